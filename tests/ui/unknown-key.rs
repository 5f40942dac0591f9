//! A key that does not exist.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, colour: red }
}

fn main() {}
