//! An invariant that does not exist.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: { third_moment: zero } }
}

fn main() {}
