//! A tolerance for finding a layout that is declared.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, layout_tolerance: 1e-12 }
}

fn main() {}
