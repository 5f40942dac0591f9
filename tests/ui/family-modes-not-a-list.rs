//! Modes of a family that are no list.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: ..4 }
}

fn main() {}
