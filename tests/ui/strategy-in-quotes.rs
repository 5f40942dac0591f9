//! A word in quotes.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, strategy: "lanes" }
}

fn main() {}
