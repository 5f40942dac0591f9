//! No comma between two keys.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {} scalar: f32 }
}

fn main() {}
