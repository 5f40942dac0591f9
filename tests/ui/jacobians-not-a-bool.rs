//! Jacobians are wanted or not: true or false.
ffrf::flexible_body! {
    pub struct Body { modes: 1, layout: {}, jacobians: yes }
}

fn main() {}
