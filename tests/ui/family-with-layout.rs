//! Invariants at run time in a family.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: [2], layout: { first_moment: zero } }
}

fn main() {}
