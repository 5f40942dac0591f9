//! A family without modes.
ffrf::flexible_body! {
    pub family bodies { model: "models/sound.ffrf.json", scalar: [f64, f32] }
}

fn main() {}
