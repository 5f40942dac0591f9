//! The same invariant twice.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: { damping: zero, damping: diagonal } }
}

fn main() {}
