//! Mailboxes that no ray clears: a stamp is the number of the last ray that was tested against the object.

use std::cell::Cell;

thread_local! {
    /// The mailboxes of a thread, for rays of any scene: a new ray has a new number, and what is left from
    /// others is not mistaken for it.
    static OF_THREAD: Cell<Vec<u32>> = const { Cell::new(Vec::new()) };
    /// The number of the thread's last ray.
    static LAST_RAY: Cell<u32> = const { Cell::new(0) };
}

/// Which objects were tested against a ray?
#[derive(Debug)]
pub(super) struct Mailboxes {
    /// How many objects there are.
    objects: usize,
    /// The object that was tested first: most rays test no other, and need no mailbox for it.
    first: Option<usize>,
    /// The mailboxes, once there is another.
    others: Option<Stamps>,
}

impl Mailboxes {
    /// Those of a new ray, for a number of objects.
    #[inline]
    pub(super) fn for_ray(objects: usize) -> Self {
        Self {
            objects,
            first: None,
            others: None,
        }
    }

    /// Is this the first time that the ray is tested against this object?
    #[inline]
    pub(super) fn is_first(&mut self, object: usize) -> bool {
        match self.first {
            None => {
                self.first = Some(object);
                true
            }
            Some(first) => first != object && self.is_first_of_others(object),
        }
    }

    #[inline]
    fn is_first_of_others(&mut self, object: usize) -> bool {
        match &mut self.others {
            Some(stamps) => stamps.is_first(object),
            None => self.open_others().is_first(object),
        }
    }

    // apart: once for a ray at most, and the walk stays small
    #[cold]
    #[inline(never)]
    fn open_others(&mut self) -> &mut Stamps {
        self.others.insert(Stamps::for_ray(self.objects))
    }
}

/// The mailboxes of all objects, for one ray.
#[derive(Debug)]
struct Stamps {
    /// By object, the number of the last ray that was tested against it.
    stamps: Vec<u32>,
    ray: u32,
}

impl Stamps {
    /// Those of this thread, for a new ray and a number of objects. Nothing is cleared for it.
    fn for_ray(objects: usize) -> Self {
        let mut stamps = OF_THREAD.take();
        let ray = LAST_RAY.get().wrapping_add(1);
        if ray == 0 {
            // the numbers begin anew: old stamps must go
            stamps.clear();
        }
        let ray = ray.max(1);
        LAST_RAY.set(ray);
        if stamps.len() < objects {
            stamps.resize(objects, 0);
        }
        Self { stamps, ray }
    }

    /// Is the object's stamp not yet that of the ray? It is from now on.
    #[inline]
    fn is_first(&mut self, object: usize) -> bool {
        let stamp = &mut self.stamps[object];
        let first = *stamp != self.ray;
        *stamp = self.ray;
        first
    }
}

impl Drop for Stamps {
    #[inline]
    fn drop(&mut self) {
        OF_THREAD.set(std::mem::take(&mut self.stamps));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_is_new_once_for_each_ray() {
        for _ in 0..3 {
            let mut mailboxes = Mailboxes::for_ray(4);
            for (object, is_first) in [
                (2, true),
                (2, false),
                (3, true),
                (2, false),
                (0, true),
                (3, false),
                (2, false),
                (0, false),
            ] {
                assert_eq!(mailboxes.is_first(object), is_first, "{object}");
            }
        }
    }

    #[test]
    fn after_the_last_number_no_old_stamp_is_taken_for_a_new_one() {
        LAST_RAY.set(0);
        assert!(Stamps::for_ray(1).is_first(0));
        LAST_RAY.set(u32::MAX);
        assert!(Stamps::for_ray(1).is_first(0));
    }
}
