//! A key without a value.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, scalar: }
}

fn main() {}
