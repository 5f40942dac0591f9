//! Lanes over invariants that come at run time need a diagonal modal mass; this layout leaves it dense.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, strategy: lanes }
}

fn main() {}
