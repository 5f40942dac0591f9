//! The number of modes is a key, not a parameter of the type.
ffrf::flexible_body! {
    pub struct Body<const M: usize> { modes: 1, layout: {} }
}

fn main() {}
