//! What the kinds of ray tracing are called in a figure, by the words of the slides.

use crate::trace::Transport;

/// The name of a kind.
pub(in crate::figure) fn transport_name(transport: Transport) -> &'static str {
    match transport {
        Transport::Backward => "backward",
        Transport::HybridLight => "rays to the light",
        Transport::Forward => "forward",
        Transport::HybridStored => "storage on surfaces",
        Transport::HybridConnected => "connecting lines",
    }
}
