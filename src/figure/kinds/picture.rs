//! The picture of a scene; the pixels whose trace is drawn are marked, each with what became of its rays.

use crate::figure::kind::Kind;
use crate::figure::parts::picture;

pub(super) const KIND: Kind = Kind {
    draw: picture::draw,
    height: 460.0,
    usual: &[],
    more: &[],
};
