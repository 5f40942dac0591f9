//! A strategy that does not exist.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, strategy: fastest }
}

fn main() {}
