//! What a check may take.

/// Bytes of memory: more than any right function needs, and less than any machine has.
pub const MEMORY: u64 = 2 << 30;

/// Bytes of a file.
const FILE: u64 = 64 << 20;

/// Limits this process, where the system can: seconds of CPU time, memory, sizes of files.
pub fn limit(seconds: u64) {
    #[cfg(unix)]
    {
        use rlimit::{Resource, setrlimit};
        // a system without one of these limits still has the others, and the time limit of who started the check
        let _ = setrlimit(Resource::CPU, seconds, seconds + 1);
        let _ = setrlimit(Resource::FSIZE, FILE, FILE);
        #[cfg(not(target_os = "macos"))]
        let _ = setrlimit(Resource::AS, MEMORY, MEMORY);
        let _ = setrlimit(Resource::CORE, 0, 0);
    }
    #[cfg(not(unix))]
    let _ = (seconds, FILE);
}
