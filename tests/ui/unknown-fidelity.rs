//! A fidelity that does not exist.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, fidelity: quadratic }
}

fn main() {}
