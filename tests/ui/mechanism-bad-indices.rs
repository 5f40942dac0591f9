//! Indices of arrays that do not exist.
ffrf::mechanism! {
    pub struct Chain {
        bodies: { hook: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }, links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }; 3] },
        joints: {
            first: revolute(ground, links.END),
            second: revolute(ground, links[3]),
            third: revolute(ground, hook[0]),
            fourth: revolute(ground, links[i]),
            hinges: for i in 0..3 { revolute(links[i].END, links[i + 1]) },
            others: for i in 0..2 { revolute(links[j].END, links[i as usize]) },
            ground_marker: revolute(ground.ORIGIN, links[0]),
            place_of_marker: revolute(ground, links[0].END.at([0.0, 0.0, 0.0])),
        },
    }
}

fn main() {}
