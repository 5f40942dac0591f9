//! A declared layout without the number of modes.
ffrf::flexible_body! {
    pub struct Body { layout: {} }
}

fn main() {}
