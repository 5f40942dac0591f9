//! Which way the motion of an eigenvector goes round an axis.

use ffrf_runtime::{Motion, Observables as _, PlacedMarker, State};
use nalgebra::{Complex, DMatrix, DVector, UnitQuaternion, Vector3};

use super::spin::States;
use crate::{HostMechanism, HostModal};

/// Which way an eigenmode goes round the axis of rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Whirl {
    /// With the rotation.
    Forward,
    /// Against it.
    Backward,
    /// To and fro in a plane, as far as numbers tell.
    Planar,
    /// Along the axis, or about it.
    Axial,
    /// No circle in something that is not round: told as the rotating frame sees it, in space it has two frequencies.
    Rotating,
}

impl Whirl {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Backward => "backward",
            Self::Planar => "planar",
            Self::Axial => "axial",
            Self::Rotating => "rotating",
        }
    }
}

/// Shares of an eigenvector's motion, weighted by masses: circles with and against the rotation, and along or about the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shares {
    pub(super) forward: f64,
    pub(super) backward: f64,
    pub(super) axial: f64,
}

/// Difference of forward and backward below which a motion counts as planar, relative to their sum.
const PLANAR: f64 = 1e-6;

impl Shares {
    /// Of the motion `basis` (n x f places) times the first half of `vector`, about `axis` (unit, inertial).
    pub(super) fn new(
        mechanism: &HostMechanism,
        states: &States,
        basis: &DMatrix<f64>,
        vector: &DVector<Complex<f64>>,
        axis: &Vector3<f64>,
    ) -> Self {
        let freedom = basis.ncols();
        let part = |of: fn(&Complex<f64>) -> f64| {
            basis * DVector::from_iterator(freedom, vector.iter().take(freedom).map(of))
        };
        let parts = [part(|entry| entry.re), part(|entry| entry.im)];
        // z of this triad along the axis
        let across = UnitQuaternion::rotation_between(&Vector3::z(), axis)
            .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
        let mut shares = Self { forward: 0.0, backward: 0.0, axial: 0.0 };
        let mut add = |weight: f64, real: &Vector3<f64>, imaginary: &Vector3<f64>| {
            let (re, im) = (across.inverse() * real, across.inverse() * imaginary);
            let [x, y, z] = [0, 1, 2].map(|k| Complex::<f64>::new(re[k], im[k]));
            let i = Complex::<f64>::i();
            shares.forward += weight * (x + i * y).norm_sqr() / 2.0;
            shares.backward += weight * (x - i * y).norm_sqr() / 2.0;
            shares.axial += weight * z.norm_sqr();
        };
        let mut start = 0;
        let bodies = mechanism.bodies().iter().zip(mechanism.markers()).zip(states);
        for ((body, markers), state) in bodies {
            let size = 6 + body.mode_count();
            let motions = parts.each_ref().map(|part| motion(state, part, start, size));
            let mass = body.mass();
            let center = body.first_mass_moment(&state.modal_coordinates) / mass;
            let still = ffrf_runtime::Marker::rigid(center, &state.modal_coordinates);
            let points: Vec<_> = if body.mode_count() > 0 && !markers.is_empty() {
                markers.iter().collect()
            } else {
                vec![&still]
            };
            let inertia = ffrf_runtime::FlexibleBody::prepare(
                body,
                &state.modal_coordinates,
                &Vector3::zeros(),
                &state.modal_rates,
            )
            .inertia
            .trace()
                / 3.0;
            let count = points.len() as f64;
            for marker in points {
                let placed = PlacedMarker::new(marker, state);
                let [re, im] = motions.each_ref().map(|motion| placed.twist(motion));
                add(mass / count, &re[0], &im[0]);
                add(inertia / count, &re[1], &im[1]);
            }
            start += size;
        }
        shares
    }

    pub(super) fn whirl(&self) -> Whirl {
        let across = self.forward + self.backward;
        if self.axial > across {
            Whirl::Axial
        } else if (self.forward - self.backward).abs() <= PLANAR * across {
            Whirl::Planar
        } else if self.forward > self.backward {
            Whirl::Forward
        } else {
            Whirl::Backward
        }
    }
}

/// The part of one body of a change of places, resolved in its frame.
fn motion(state: &State<HostModal>, places: &DVector<f64>, start: usize, size: usize) -> Motion<HostModal> {
    Motion {
        linear: state.to_body(&places.fixed_rows::<3>(start).into_owned()),
        angular: places.fixed_rows::<3>(start + 3).into_owned(),
        modal: HostModal(places.rows(start + 6, size - 6).into_owned()),
    }
}
