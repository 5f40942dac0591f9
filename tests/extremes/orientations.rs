//! Quaternions that are scaled, negated, or half a turn apart.

use std::f64::consts::PI;

use ffrf::mechanism::Constrained;
use ffrf::nalgebra::{UnitQuaternion, Vector3};
use ffrf::{FlexibleBody, FreeBody, rotation};

use crate::row;
use crate::settings::{Rod, Setting, largest};
use crate::table::{Figure, Real, Section, below, refused};

/// A quaternion is scaled by a product with a division and a root behind it: some roundings.
const ROUNDED: [f64; 2] = [1e-15, 1e-6];

pub fn section() -> Section {
    Section {
        title: "Quaternions scaled, negated, near 180 degrees",
        text: "Euler parameters of any size are scaled to unit norm (distance from the unit ones); those too close to zero or \
               too large for a direction are refused. A quaternion and its negative are one orientation: all of the motion but \
               the sign is the same to the last bit. A joint holds directions up to their sign: what is put into it reversed stays so \
               when it is assembled. A torsion spring beside half a turn pulls by its stiffness times its angle, the shorter \
               way on either side (relative error of what it does in a step).",
        rows: vec![
            row!("scaled by 2⁻²⁰", scaled, 2.0_f64.powi(-20)),
            row!("scaled by 1e10", scaled, 1e10),
            row!("scaled by 1e30", scaled, 1e30),
            row!("scaled by 0", without_direction, 0.0),
            row!("scaled by infinity", without_direction, f64::INFINITY),
            row!("negated, free rod", negated),
            row!("hinge with its axis reversed", reversed_hinge),
            row!("torsion spring at 179.9 and 180.1 degrees", torsion_spring),
        ],
    }
}

fn unit() -> [f64; 4] {
    let parameters = [0.5, -0.7, 0.3, 0.1_f64];
    let norm = parameters.iter().map(|x| x * x).sum::<f64>().sqrt();
    parameters.map(|x| x / norm)
}

fn scaled<T: Real>(scale: f64) -> Figure {
    let found = rotation::from_euler_parameters(unit().map(|x| T::of(x * scale)));
    let Some(found) = found else { return Figure::Refused("no direction".to_owned()) };
    let found = rotation::euler_parameters(&found);
    below::<T>(largest(found.iter().zip(unit()).map(|(found, unit)| (found.double() - unit).abs())), ROUNDED)
}

fn without_direction<T: Real>(scale: f64) -> Figure {
    assert!(rotation::from_euler_parameters(unit().map(|x| T::of(x * scale))).is_none());
    Figure::Refused("no direction".to_owned())
}

fn negated<T: Real>() -> Figure {
    let parameters = unit().map(T::of);
    let start = |sign: T| {
        let orientation = rotation::from_euler_parameters(parameters.map(|x| x * sign)).unwrap();
        let mut body = FreeBody::new(Rod)
            .with_orientation(orientation)
            .with_velocity(Vector3::new(T::one(), T::of(2.0), T::of(3.0)))
            .with_spin(Vector3::new(T::of(10.0), T::of(200.0), T::of(-30.0)));
        body.state.modal_coordinates.as_mut_slice()[1] = T::of(1e-4);
        body
    };
    let (mut plus, mut minus) = (start(T::one()), start(-T::one()));
    let step = FlexibleBody::<T>::largest_stable_step(&Rod).unwrap() * T::of(0.25);
    for _ in 0..1_000 {
        plus.step_rk4(step, &()).unwrap();
        minus.step_rk4(step, &()).unwrap();
    }
    minus.state.orientation = UnitQuaternion::new_unchecked(-minus.state.orientation.into_inner());
    assert_eq!(plus.state, minus.state);
    Figure::Holds("same bits")
}

/// A wheel in its hinge with the axis the wrong way round, which is a solution of the hinge's rows as well.
fn reversed_hinge<T: Real>() -> Figure {
    let mut setting = Setting::<T>::of(
        "[simulation]\nduration = 1.0\nstep = 1e-3\n\
         [bodies.wheel]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"wheel\"\n",
    );
    setting.states[0].orientation = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), T::pi());
    let system = Constrained(&setting.mechanism);
    match system.assemble(T::zero(), setting.states.clone(), T::of(1e-4)) {
        Ok((states, _)) => {
            let axis = states[0].orientation.transform_vector(&Vector3::z()).z.double();
            assert!((axis + 1.0).abs() < ROUNDED[1], "{axis}");
            Figure::Holds("stays reversed")
        }
        Err(error) => refused(error),
    }
}

/// The angular acceleration that a torsion spring at rest at zero gives, beside half a turn on either side.
fn torsion_spring<T: Real>() -> Figure {
    let mut worst = 0.0;
    for degrees in [179.9_f64, 180.1] {
        let half = 0.5 * degrees * PI / 180.0;
        let mut setting = Setting::<T>::of(&format!(
            "[simulation]\nduration = 1.0\nstep = 1e-3\n\
             [bodies.wheel]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\n\
             orientation = [{}, 0.0, 0.0, {}]\n\
             [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"wheel\"\n\
             [forces.coil]\nkind = \"torsion_spring\"\nsecond = \"wheel\"\nstiffness = 2.0\nrest = 0.0\n",
            half.cos(),
            half.sin(),
        ));
        let step = T::of(1e-4);
        setting.step(step, false).unwrap();
        // the angle in (-180, 180] degrees
        let angle = if degrees > 180.0 { degrees - 360.0 } else { degrees } * PI / 180.0;
        let expected = -2.0 * angle / 0.1 * 1e-4;
        let found = setting.states[0].angular_velocity.z.double();
        worst = largest([worst, (found / expected - 1.0).abs()]);
    }
    below::<T>(worst, [1e-6, 1e-4])
}
