//! Where an event can happen.

/// What an event of a kind belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::trace) enum KindPlace {
    /// A structure, before the first pixel.
    Building,
    /// A path of light.
    Path,
    /// A pixel.
    Pixel,
    /// A path or a pixel.
    Either,
}
