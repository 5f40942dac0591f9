//! A fidelity that is neither a level nor a list.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, fidelity: 2 }
}

fn main() {}
