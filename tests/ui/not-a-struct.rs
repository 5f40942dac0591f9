//! Something else than a struct.
ffrf::flexible_body! {
    pub enum Body { modes: 1, layout: {} }
}

fn main() {}
