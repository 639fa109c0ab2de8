//! All mistakes.

use crate::mistake::{
    Mistake, bound, epsilon, eye, grid, hierarchy, normal, plane, polygon, ray, recursion,
    reflection, refraction, root, shade, shadow, slab,
};

/// The mistakes of each subject, in the order of the course.
const SUBJECTS: [&[Mistake]; 16] = [
    eye::MISTAKES,
    ray::MISTAKES,
    root::MISTAKES,
    epsilon::MISTAKES,
    normal::MISTAKES,
    shade::MISTAKES,
    shadow::MISTAKES,
    plane::MISTAKES,
    polygon::MISTAKES,
    reflection::MISTAKES,
    refraction::MISTAKES,
    recursion::MISTAKES,
    slab::MISTAKES,
    bound::MISTAKES,
    hierarchy::MISTAKES,
    grid::MISTAKES,
];

/// All mistakes, in the order of the course.
pub fn mistakes() -> impl Iterator<Item = &'static Mistake> {
    SUBJECTS.into_iter().flatten()
}

/// The mistake of a name.
pub fn mistake(name: &str) -> Option<&'static Mistake> {
    mistakes().find(|mistake| mistake.name == name)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn each_mistake_has_a_name_of_its_own_and_one_sentence() {
        let mut names = BTreeSet::new();
        for of in mistakes() {
            assert!(names.insert(of.name), "{}", of.name);
            let sentence = of.sentence;
            assert!(sentence.ends_with('.'), "{sentence}");
            assert_eq!(sentence.matches(". ").count(), 0, "{sentence}");
            assert!(!of.spoils.is_empty());
            assert_eq!(mistake(of.name).map(|of| of.sentence), Some(sentence));
        }
        assert_eq!(names.len(), 60, "{names:?}");
        assert!(mistake("no such mistake").is_none());
    }
}
