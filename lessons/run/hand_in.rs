//! Which cases the checks have. A lecturer's export writes this file.

/// What the seeded cases are made from; absent in the public course.
pub(crate) const SECRET: Option<&str> = None;

/// Is there a lecturer who has other cases?
pub(crate) const HAS_OTHERS: bool = false;
