//! Chains, stars and binary trees of connecting rods with four modes.

use std::hint::black_box;

use ffrf::System;
use ffrf::mechanism::{Assembly, Constrained};
use ffrf::nalgebra::Vector3;

use crate::{least, report};

ffrf::flexible_body! {
    /// The connecting rod of the project with four modes.
    pub struct Link { model: "../../../../models/conrod.ffrf.json", modes: ..4 }
}

/// A chain, a star on a rigid hub and a tree of so many links.
macro_rules! links {
    ($count:literal $joints:literal $chain:ident $star:ident $tree:ident) => {
        ffrf::mechanism! {
            pub struct $chain {
                bodies: { links: [Link; $count] },
                gravity: [0.0, -9.81, 0.0],
                joints: {
                    first: revolute(ground, links[0].BIG_END, axis: z),
                    hinges: for i in 0..$joints { revolute(links[i].SMALL_END, links[i + 1].BIG_END, axis: z) },
                },
            }
        }
        ffrf::mechanism! {
            pub struct $star {
                bodies: { hub: rigid { mass: 1.0, inertia: [1e-2; 3] }, links: [Link; $count] },
                gravity: [0.0, -9.81, 0.0],
                joints: {
                    center: revolute(ground, hub, axis: z),
                    roots: for i in 0..$count { revolute(hub, links[i].BIG_END, axis: z) },
                },
            }
        }
        ffrf::mechanism! {
            pub struct $tree {
                bodies: { links: [Link; $count] },
                gravity: [0.0, -9.81, 0.0],
                joints: {
                    root: revolute(ground, links[0].BIG_END, axis: z),
                    branches: for i in 1..$count { revolute(links[(i - 1) / 2].SMALL_END, links[i].BIG_END, axis: z) },
                },
            }
        }
    };
}
links!(2 1 Chain2 Star2 Tree2);
links!(4 3 Chain4 Star4 Tree4);
links!(8 7 Chain8 Star8 Tree8);
links!(16 15 Chain16 Star16 Tree16);
links!(32 31 Chain32 Star32 Tree32);
links!(64 63 Chain64 Star64 Tree64);

ffrf::mechanism! {
    pub struct Chain1 {
        bodies: { links: [Link; 1] },
        gravity: [0.0, -9.81, 0.0],
        joints: { first: revolute(ground, links[0].BIG_END, axis: z) },
    }
}

/// Times the evaluation in a moving, deformed state; joints are open, which changes no work.
macro_rules! time {
    ($rounds:expr, $topology:literal, $($name:ident $count:literal)*) => {$({
        let model = $name::new([Link; $count]);
        let mut state = model.at_rest();
        for (k, link) in state.links.iter_mut().enumerate() {
            link.position = Vector3::new(0.15 * k as f64, 0.01, 0.02);
            link.angular_velocity = Vector3::new(0.1, 0.2, 0.3 + 0.01 * k as f64);
            for mode in 0..4 {
                link.modal_coordinates[mode] = 1e-5 * ((3 * k + mode) as f64).sin();
                link.modal_rates[mode] = 1e-2 * ((5 * k + mode) as f64).cos();
            }
        }
        let zero = model.no_change(&state);
        let time = least($rounds, || Constrained(&model).rates(0.0, black_box(&state), &zero).expect("accelerations exist"));
        report($topology, $count, time, &[]);
    })*};
}

pub fn run(rounds: usize) {
    time!(rounds, "chain", Chain1 1 Chain2 2 Chain4 4 Chain8 8 Chain16 16 Chain32 32 Chain64 64);
    time!(rounds, "star", Star2 2 Star4 4 Star8 8 Star16 16 Star32 32 Star64 64);
    time!(rounds, "tree", Tree2 2 Tree4 4 Tree8 8 Tree16 16 Tree32 32 Tree64 64);
}
