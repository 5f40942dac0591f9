//! A scalar type that is not there.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, scalar: f16 }
}

fn main() {}
