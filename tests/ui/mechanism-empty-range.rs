//! Ranges and arrays without anything.
ffrf::mechanism! {
    pub struct One {
        bodies: { links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }; 3] },
        joints: { hinges: for i in 2..2 { revolute(links[i].END, links[i + 1]) } },
    }
}

ffrf::mechanism! {
    pub struct Two {
        bodies: { links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }; 0] },
    }
}

ffrf::mechanism! {
    pub struct Three { bodies: {} }
}

ffrf::mechanism! {
    pub struct Four { gravity: [0.0, 0.0, -9.81] }
}

fn main() {}
