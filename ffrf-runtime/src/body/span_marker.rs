//! A marker over a step: mean place and motion, and forces that do exactly the work of its displacement.

use nalgebra::{Matrix3, RealField, Vector3};

use super::bent_marker::{marker_motion, place};
use super::marker::{combine, transposed};
use super::modal_vector::scatter;
use super::span::{Span, half_way_orientation, matrix, turn_between};
use super::{FlexibleBody, GeneralisedForce, Marker, MarkerMotion, ModalVector, Wrench};
use crate::six::{Square, zeros};

/// A marker of a body over a [`Span`].
pub(crate) struct SpanMarker<'a, B: FlexibleBody<T>, T: RealField + Copy> {
    body: &'a B,
    marker: &'a Marker<B::Modal, T>,
    /// The rows half way, if they follow the deformation. They are linear in q, and with stiffness that is symmetric: place and small
    /// rotation change over the step by these rows times Δq, exactly.
    bent: Option<Marker<B::Modal, T>>,
    span: &'a Span<B::Modal, T>,
    /// Mean of the places at both ends from the frame origin, body frame; x + Ψ q̄ where rows are constant.
    arm: Vector3<T>,
    /// Mean of the small rotations.
    rotation: Vector3<T>,
    /// 1 / (1 + ϑ_0 · ϑ_1 / 4).
    share: T,
}

impl<'a, B: FlexibleBody<T>, T: RealField + Copy> SpanMarker<'a, B, T> {
    pub(crate) fn new(body: &'a B, marker: &'a Marker<B::Modal, T>, span: &'a Span<B::Modal, T>) -> Self {
        let (half, quarter): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(0.25));
        let [first_arm, first] = place(body, marker, &span.begin.modal_coordinates);
        let [last_arm, last] = place(body, marker, &span.end.modal_coordinates);
        Self {
            body,
            marker,
            bent: body.bent_marker(marker, &span.middle.modal_coordinates),
            span,
            arm: (first_arm + last_arm) * half,
            rotation: (first + last) * half,
            share: T::one() / (T::one() + first.dot(&last) * quarter),
        }
    }

    /// Place and motion at both ends.
    pub(crate) fn ends(&self) -> [MarkerMotion<T>; 2] {
        [&self.span.begin, &self.span.end]
            .map(|state| marker_motion(self.body, self.marker, state, &matrix(&state.orientation)))
    }

    /// Means of the place at both ends; velocities are displacement and rotation vector over the step.
    ///
    /// The axes are the means of those at both ends, no triad: with them products of two factors change exactly as they
    /// should. No biases.
    pub(crate) fn motion(&self) -> MarkerMotion<T> {
        let half: T = nalgebra::convert(0.5);
        let [first, last] = self.ends();
        let mut motion = MarkerMotion::fixed(
            (first.position + last.position) * half,
            half_way_orientation(&first.orientation, &last.orientation),
        );
        motion.mean_axes = Some((first.axes() + last.axes()) * half);
        motion.velocity = (last.position - first.position) / self.span.step;
        motion.angular_velocity = turn_between(&first.orientation, &last.orientation) / self.span.step;
        motion
    }

    /// [`generalised_force`](Self::generalised_force) of six wrenches, see
    /// [`PlacedMarker::generalised_forces`](super::PlacedMarker).
    pub(crate) fn generalised_forces(&self, wrenches: &Square<T>, modal: &mut [[T; 6]]) -> Square<T> {
        let mut frame = zeros();
        for column in 0..6 {
            let [x, y, z, r_x, r_y, r_z] = wrenches.map(|component| component[column]);
            let wrench = Wrench { force: Vector3::new(x, y, z), moment: Vector3::new(r_x, r_y, r_z) };
            let force = self.generalised_force(&wrench);
            scatter(force.modal.as_slice(), column, modal);
            scatter(force.force.as_slice(), column, &mut frame[..3]);
            scatter(force.moment.as_slice(), column, &mut frame[3..]);
        }
        frame
    }

    /// Generalised force, dual to the mean velocities, of a wrench that does the work f · Δr + μ · θ.
    ///
    /// θ, whose Cayley map turns the marker's triad from beginning to end, is composed of a = h Ω̄ and of b = A_0 c with
    /// c = W̄ Δϑ, W̄ = (I + ½ ϑ̄~) / (1 + ϑ_0 · ϑ_1 / 4): θ = (a + b + ½ a × b) / (1 - a · b / 4), where the product is shared
    /// between both.
    pub(crate) fn generalised_force(&self, wrench: &Wrench<T>) -> GeneralisedForce<B::Modal, T> {
        let (half, quarter): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(0.25));
        let span = self.span;
        let mut turning = span.end.modal_coordinates.clone();
        turning.add_scaled(-T::one(), &span.begin.modal_coordinates);
        let rows = self.bent.as_ref().unwrap_or(self.marker);
        let change = combine(&rows.rotation, &turning);
        let relative = (change + self.rotation.cross(&change) * half) * self.share;
        let (a, b) = (span.turn, span.begin.to_inertial(&relative));
        let composed = T::one() / (T::one() - a.dot(&b) * quarter);
        let on_frame = (wrench.moment + b.cross(&wrench.moment) * quarter) * composed;
        let on_modes = (wrench.moment - a.cross(&wrench.moment) * quarter) * composed;
        let rotation: &Matrix3<T> = &span.mean_rotation;
        let force = span.to_mean(&wrench.force);
        let moment = span.to_mean(&((rotation * self.arm).cross(&wrench.force) + on_frame));
        let mut modal = transposed(&rows.translation, &force);
        let local = span.begin.to_body(&on_modes);
        let turned = (local - self.rotation.cross(&local) * half) * self.share;
        for (row, component) in rows.rotation.iter().zip(turned.iter()) {
            modal.add_scaled(*component, row);
        }
        GeneralisedForce { force, moment, modal }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, UnitQuaternion, Vector2, Vector4};

    use super::super::{Increment, Motion, State};
    use super::*;

    /// Sums of some twenty products of order one.
    const ROUND_OFF: f64 = 1e-14;

    /// A long step: far from small rotations.
    fn span() -> Span<Vector2<f64>, f64> {
        let begin = State {
            position: Vector3::new(0.3, -0.2, 0.5),
            orientation: UnitQuaternion::from_euler_angles(0.4, -0.9, 1.3),
            modal_coordinates: Vector2::new(0.3, -0.2),
            velocity: Vector3::new(1.0, 0.5, -0.7),
            angular_velocity: Vector3::new(0.8, -1.1, 0.6),
            modal_rates: Vector2::new(0.9, 1.2),
        };
        let velocities = Increment {
            velocity: Vector3::new(-0.3, 0.2, 0.4),
            angular_velocity: Vector3::new(0.2, 0.7, -0.3),
            modal_rates: Vector2::new(0.5, -0.8),
            ..Increment::zeros(&begin.modal_coordinates)
        };
        Span::new(&begin, &velocities, 0.7)
    }

    #[test]
    fn a_wrench_does_the_work_of_the_displacement() {
        let span = span();
        for body in [Points::new(), Points::with_loads()] {
            wrenches_work(&body, &span);
        }
    }

    fn wrenches_work(body: &Points, span: &Span<Vector2<f64>, f64>) {
        let rows =
            |k: f64| core::array::from_fn(|i| Vector2::new((k + i as f64).sin(), (2.0 * k - i as f64).cos()));
        let marker = Marker {
            position: Vector3::new(0.4, 0.1, -0.3),
            translation: rows(0.3),
            rotation: rows(1.1),
            stressing: Some(0),
        };
        let at = SpanMarker::new(body, &marker, span);
        let motion = at.motion();
        let mean = mean_velocities(span);
        for k in 0..6 {
            let mut wrench = Wrench::zero();
            if k < 3 {
                wrench.force[k] = 1.0;
            } else {
                wrench.moment[k - 3] = 1.0;
            }
            let work = at.generalised_force(&wrench).power(&mean);
            let expected = wrench.power(&motion.velocity, &motion.angular_velocity);
            assert!((work - expected).abs() < ROUND_OFF, "{k}: {work} {expected}");
        }
        // the rotation vector takes the mean axes to the change of the axes
        let ends = at.ends().map(|end| end.axes());
        let change = (motion.angular_velocity * span.step).cross_matrix() * motion.axes();
        assert!((ends[1] - ends[0] - change).amax() < ROUND_OFF);
    }

    /// ū, ω̄ and q̇̄.
    fn mean_velocities(span: &Span<Vector2<f64>, f64>) -> Motion<Vector2<f64>, f64> {
        let [first, last] = [span.begin.velocities(), span.end.velocities()];
        let mut mean = first;
        mean.add_scaled(1.0, &last);
        mean.scale(0.5);
        mean
    }

    #[test]
    fn kinetic_energy_changes_by_the_work_of_what_is_missing() {
        // any M that is quadratic in q: a body of four point masses, with modes that are special in nothing
        let body = Points::new();
        let span = span();
        let none = GeneralisedForce::zeros(&span.begin.modal_coordinates);
        let (_, missing) = span.stage(&body, &none).unwrap();
        // without forces, what is missing is the change of momentum that nothing explains: its work is that of the energy
        let work = -missing.power(&mean_velocities(&span));
        let change = body.energy(&span.end) - body.energy(&span.begin);
        assert!((work - change).abs() < ROUND_OFF * 10.0, "{work} {change}");
    }

    /// Four point masses: the body from its definition, in coordinates of the inertial frame.
    struct Points {
        masses: Vector4<f64>,
        places: [Vector3<f64>; 4],
        shapes: [[Vector3<f64>; 2]; 4],
        /// Stiffness of unit loads at a marker: symmetric, else special in nothing.
        loads: Option<[[[f64; 2]; 2]; 6]>,
    }

    impl Points {
        fn new() -> Self {
            let vector = |k: f64| Vector3::new((1.3 * k).sin(), (0.7 * k + 1.0).cos(), (2.1 * k).sin());
            Self {
                masses: Vector4::new(0.5, 0.8, 0.6, 0.9),
                places: core::array::from_fn(|i| vector(i as f64)),
                shapes: core::array::from_fn(|i| [vector(5.0 + i as f64), vector(9.5 + 2.0 * i as f64)]),
                loads: None,
            }
        }

        fn with_loads() -> Self {
            let stiffness = |k: f64| [[k.sin(), (1.7 * k).cos()], [(1.7 * k).cos(), (0.4 * k).sin()]];
            Self { loads: Some(core::array::from_fn(|k| stiffness(0.3 + k as f64))), ..Self::new() }
        }

        fn arms(&self, q: &Vector2<f64>) -> [Vector3<f64>; 4] {
            core::array::from_fn(|i| self.places[i] + self.shapes[i][0] * q[0] + self.shapes[i][1] * q[1])
        }

        fn energy(&self, state: &State<Vector2<f64>, f64>) -> f64 {
            let arms = self.arms(&state.modal_coordinates);
            let rates = &state.modal_rates;
            (0..4)
                .map(|i| {
                    let shift = self.shapes[i][0] * rates[0] + self.shapes[i][1] * rates[1];
                    let local = state.angular_velocity.cross(&arms[i]) + shift;
                    0.5 * self.masses[i] * (state.velocity + state.to_inertial(&local)).norm_squared()
                })
                .sum()
        }
    }

    impl FlexibleBody<f64> for Points {
        type Modal = Vector2<f64>;

        fn undeformed(&self) -> Vector2<f64> {
            SVector::zeros()
        }

        fn modal_mass(&self) -> super::super::ModalMatrix<Vector2<f64>, f64> {
            let entry = |mu: usize, nu: usize| {
                (0..4).map(|i| self.masses[i] * self.shapes[i][mu].dot(&self.shapes[i][nu])).sum()
            };
            super::super::ModalMatrix::Dense(nalgebra::Matrix2::from_fn(entry))
        }

        fn stiffness(&self) -> super::super::ModalMatrix<Vector2<f64>, f64> {
            super::super::ModalMatrix::Diagonal(SVector::zeros())
        }

        fn bent_marker(
            &self,
            marker: &Marker<Vector2<f64>, f64>,
            q: &Vector2<f64>,
        ) -> Option<Marker<Vector2<f64>, f64>> {
            self.loads.as_ref().map(|loads| super::super::bent(marker, loads, q, core::convert::identity))
        }

        fn damping(&self) -> super::super::ModalMatrix<Vector2<f64>, f64> {
            super::super::ModalMatrix::Diagonal(SVector::zeros())
        }

        fn prepare(
            &self,
            q: &Vector2<f64>,
            omega: &Vector3<f64>,
            q_dot: &Vector2<f64>,
        ) -> super::super::Prepared<Vector2<f64>, f64> {
            let arms = self.arms(q);
            let mut prepared = super::super::Prepared {
                mass: self.masses.sum(),
                first_moment: Vector3::zeros(),
                inertia: Matrix3::zeros(),
                modal_first_moment: [Vector2::zeros(); 3],
                rotation_modal_coupling: [Vector2::zeros(); 3],
                quadratic_velocity: GeneralisedForce::zeros(q),
                internal_force: Vector2::zeros(),
            };
            for i in 0..4 {
                let (m, arm) = (self.masses[i], arms[i]);
                prepared.first_moment += arm * m;
                prepared.inertia += arm.cross_matrix().tr_mul(&arm.cross_matrix()) * m;
                let shift = self.shapes[i][0] * q_dot[0] + self.shapes[i][1] * q_dot[1];
                // the acceleration at constant velocities in the frame
                let pull = (omega.cross(&omega.cross(&arm)) + omega.cross(&shift) * 2.0) * m;
                prepared.quadratic_velocity.force += pull;
                prepared.quadratic_velocity.moment += arm.cross(&pull);
                for mu in 0..2 {
                    let shape = self.shapes[i][mu];
                    let turning = arm.cross(&shape) * m;
                    for axis in 0..3 {
                        prepared.modal_first_moment[axis][mu] += m * shape[axis];
                        prepared.rotation_modal_coupling[axis][mu] += turning[axis];
                    }
                    prepared.quadratic_velocity.modal[mu] += shape.dot(&pull);
                }
            }
            prepared
        }
    }
}
