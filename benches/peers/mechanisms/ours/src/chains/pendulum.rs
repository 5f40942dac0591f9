//! The rigid pendulum of n links in a plane, the same for every program: see ../../pendulum.h. Twice: by the equations of the
//! runtime, and with accelerations in straight-line code, which build/straight_line.rs has written.

use std::hint::black_box;

use ffrf::System;
use ffrf::mechanism::{Assembly, Constrained};
use ffrf::nalgebra::{UnitQuaternion, Vector3};

use crate::{least, report};

/// Units: m.
const LENGTH: f64 = 0.3;
/// Largest difference of both kinds of accelerations, relative to their norm.
const DIFFERENCE: f64 = 1e-9;

mod straight_line {
    include!(concat!(env!("OUT_DIR"), "/pendulums.rs"));
}

macro_rules! pendulum {
    ($name:ident $count:literal { $($more:tt)* } $($accelerations:tt)*) => {
        ffrf::mechanism! {
            pub struct $name {
                bodies: {
                    links: [rigid {
                        mass: 0.6,
                        center_of_mass: [0.15, 0.0, 0.0],
                        inertia: [1e-3, 5e-3, 5e-3],
                        markers: { TIP: [LENGTH, 0.0, 0.0] },
                    }; $count],
                },
                gravity: [0.0, -9.81, 0.0],
                joints: { first: revolute(ground, links[0], axis: z), $($more)* },
                $($accelerations)*
            }
        }
    };
}

/// The pendulum of so many links, twice.
macro_rules! both {
    ($general:ident $straight:ident $function:ident $count:literal { $($more:tt)* }) => {
        pendulum!($general $count { $($more)* });
        pendulum!($straight $count { $($more)* } accelerations: straight_line::$function,);
    };
}
both!(Pendulum1 Straight1 pendulum_1 1 {});
both!(Pendulum2 Straight2 pendulum_2 2 { hinges: for i in 0..1 { revolute(links[i].TIP, links[i + 1], axis: z) } });
both!(Pendulum4 Straight4 pendulum_4 4 { hinges: for i in 0..3 { revolute(links[i].TIP, links[i + 1], axis: z) } });
both!(Pendulum8 Straight8 pendulum_8 8 { hinges: for i in 0..7 { revolute(links[i].TIP, links[i + 1], axis: z) } });
both!(Pendulum16 Straight16 pendulum_16 16 { hinges: for i in 0..15 { revolute(links[i].TIP, links[i + 1], axis: z) } });
both!(Pendulum32 Straight32 pendulum_32 32 { hinges: for i in 0..31 { revolute(links[i].TIP, links[i + 1], axis: z) } });
both!(Pendulum64 Straight64 pendulum_64 64 { hinges: for i in 0..63 { revolute(links[i].TIP, links[i + 1], axis: z) } });

macro_rules! time {
    ($rounds:expr, $column:literal, $is_straight:literal, $($name:ident $count:literal)*) => {$({
        let model = $name::new();
        let mut state = model.at_rest();
        let (mut angle, mut rate) = (0.0, 0.0);
        let (mut position, mut velocity) = (Vector3::zeros(), Vector3::zeros());
        for (k, link) in state.links.iter_mut().enumerate() {
            angle += 0.1 * ((k + 1) as f64).sin();
            rate += 0.3 * (k as f64).cos();
            link.position = position;
            link.velocity = velocity;
            link.orientation = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
            link.angular_velocity.z = rate;
            let along = Vector3::new(LENGTH * angle.cos(), LENGTH * angle.sin(), 0.0);
            position += along;
            velocity += Vector3::z().cross(&along) * rate;
        }
        if $is_straight {
            // where the code does not hold, the equations would be timed in its name
            let difference = model.in_motion(state.clone()).straight_difference();
            if difference.is_none_or(|difference| difference > DIFFERENCE) {
                return Err(format!("{}, {} links: off by {difference:?}", $column, $count));
            }
        }
        let zero = model.no_change(&state);
        let evaluate = || Constrained(&model).rates(0.0, black_box(&state), &zero).expect("accelerations exist");
        let rates = evaluate();
        let mut before = 0.0;
        let joints: Vec<f64> = rates
            .links
            .iter()
            .map(|link| {
                let joint = link.angular_velocity.z - before;
                before = link.angular_velocity.z;
                joint
            })
            .collect();
        report($column, $count, least($rounds, evaluate), &joints);
    })*};
}

/// Errors: straight-line code that is not that of its pendulum.
pub fn run(rounds: usize) -> Result<(), String> {
    time!(rounds, "pendulum, ours", false,
        Pendulum1 1 Pendulum2 2 Pendulum4 4 Pendulum8 8 Pendulum16 16 Pendulum32 32 Pendulum64 64);
    time!(rounds, "pendulum, ours straight-line", true,
        Straight1 1 Straight2 2 Straight4 4 Straight8 8 Straight16 16 Straight32 32 Straight64 64);
    Ok(())
}
