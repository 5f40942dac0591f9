//! A list without an entry.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", modes: [] }
}

fn main() {}
