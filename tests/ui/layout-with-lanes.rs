//! Lanes need constant tables; these invariants come at run time.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, strategy: lanes }
}

fn main() {}
