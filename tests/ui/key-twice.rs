//! The same key twice.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, scalar: f64, scalar: f32 }
}

fn main() {}
