//! A model that is not a path in quotes.
ffrf::flexible_body! {
    pub struct Body { model: rotor }
}

fn main() {}
