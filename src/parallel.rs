//! Work on several threads, or on the one that calls where the feature `threads` is off. This file alone names `rayon`.
//!
//! Both ways give the same results in the same order, so nothing above knows which one runs.

/// Does the work for 0, 1, …, n − 1, on the threads of the current pool. The results are in order.
pub(crate) fn map<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "threads")]
    {
        use rayon::prelude::*;
        (0..count).into_par_iter().map(work).collect()
    }
    #[cfg(not(feature = "threads"))]
    (0..count).map(work).collect()
}

/// Does the work once on each thread of the current pool, all at the same time.
pub(crate) fn on_each_thread(work: impl Fn() + Sync) {
    #[cfg(feature = "threads")]
    rayon::scope(|scope| {
        for _ in 0..rayon::current_num_threads() {
            scope.spawn(|_| work());
        }
    });
    #[cfg(not(feature = "threads"))]
    work();
}

/// Does the work with a pool of this many threads as the current one.
#[cfg(all(test, feature = "threads"))]
pub(crate) fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(work)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order() {
        assert_eq!(map(5, |i| i * i), [0, 1, 4, 9, 16]);
        assert!(map(0, |i| i).is_empty());
    }
}
