//! The first modes of a model, where there is no model.
ffrf::flexible_body! {
    pub struct Body { modes: ..2, layout: {} }
}

fn main() {}
