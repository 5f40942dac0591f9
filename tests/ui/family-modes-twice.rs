//! A number of modes that is there twice.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: [2, 4, 2] }
}

fn main() {}
