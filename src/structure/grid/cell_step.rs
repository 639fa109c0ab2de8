//! One step of a walk through a grid: a cell, and how the ray leaves it.

/// One cell that a ray pierces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CellStep {
    /// i, j and k.
    pub cell: [u32; 3],
    /// Where the ray enters the cell, or where its range begins inside it.
    pub t_in: f64,
    /// Where the ray leaves the cell.
    pub t_out: f64,
    /// Where the ray hits the next plane across x, y and z; infinite if it never does.
    pub next: [f64; 3],
    /// Across which of the planes it leaves the cell; two or three at once through an edge or a corner.
    pub across: Across,
}

/// The axes along which a walk steps at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Across {
    /// Along none: the ray never leaves.
    #[default]
    None,
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Along z.
    Z,
    /// Through an edge along z.
    XY,
    /// Through an edge along y.
    XZ,
    /// Through an edge along x.
    YZ,
    /// Through a corner.
    XYZ,
}

impl Across {
    /// By the bits 1 for x, 2 for y, 4 for z.
    pub(crate) const BY_BITS: [Self; 8] = [
        Self::None,
        Self::X,
        Self::Y,
        Self::XY,
        Self::Z,
        Self::XZ,
        Self::YZ,
        Self::XYZ,
    ];
}
