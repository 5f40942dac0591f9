//! A step of a body from its beginning to its end, with means that conserve momentum and energy.
//!
//! With a bar for the mean of beginning and end, Δ for the difference, w = [u; ω; q̇] the velocities in the body frame
//! (u = Aᵀ ṗ) and π = M(q) w the momenta there, a step is
//!
//! ```text
//! A_1 = A_0 cay(h ω̄),    Δp = h Ā ū,    Δq = h q̇̄                     (Ā is the mean of both matrices, no rotation)
//! Δ(A π_u) = h F,   Δ(A π_ω) + Δp × mean(A π_u) = h N,   Δπ_q = h (f + ½ w_0ᵀ M'(q̄) w_1)
//! ```
//!
//! - Linear momentum P = A π_u changes by h F, angular momentum about the inertial origin by h N + p̄ × h F, exactly.
//! - The kinetic energy changes by the work Δp · F + h Ω̄ · N + Δq · f, exactly, with Ω̄ = A_0 ω̄ = A_1 ω̄: since
//!   Δ(½ w · π) = w̄ · Δπ - ½ w_0ᵀ ΔM w_1, where ΔM = M'(q̄) Δq because M is quadratic in q, since
//!   ΔA = h Ω̄~ Ā for the Cayley map, and since v̄ = Ā ū solves Āᵀ (I - h²/4 Ω̄~²) v̄ = ū, which the terms that are left ask for.
//! - Gravity, elastic forces and forces at markers do exactly the work that belongs to the change of their positions.
//!
//! The equations are written in components Āᵀ(.), dual to w̄. Sources: Simo, Wong, Unconditionally stable algorithms for rigid
//! body dynamics that exactly preserve energy and momentum, Int. J. Num. Meth. Eng. 31 (1991) 19-52 (rigid bodies about
//! their centre of mass, Cayley map); Gonzalez, Time integration and discrete Hamiltonian systems, J. Nonlinear Sci. 6
//! (1996) 449-467 (discrete gradients); Kinon, Betsch, Conserving integration of multibody systems with singular and
//! non-constant mass matrix including quaternion-based rigid body dynamics, Multibody Syst. Dyn. (2024),
//! doi 10.1007/s11044-024-10001-9 (mass matrices that depend on the place). The form above for flexible bodies in a
//! floating frame is derived here.

use nalgebra::{Matrix3, RealField, UnitQuaternion, Vector3};

use super::{FlexibleBody, GeneralisedForce, ImplicitBody, Increment, ModalVector, Motion, State};
use crate::rotation::turned;

/// A body at both ends of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span<V, T: RealField + Copy> {
    pub(crate) begin: State<V, T>,
    pub(crate) end: State<V, T>,
    /// Half way, with a proper rotation: for matrices and forces that need no exact work.
    pub(crate) middle: State<V, T>,
    /// From beginning to end.
    pub(crate) increment: Increment<V, T>,
    /// Ā.
    pub(crate) mean_rotation: Matrix3<T>,
    /// h Ω̄: the rotation vector of the Cayley map in inertial components.
    pub(crate) turn: Vector3<T>,
    /// h. Units: s.
    pub(crate) step: T,
}

impl<V: ModalVector<T>, T: RealField + Copy> Span<V, T> {
    /// The step of length `step` from `begin` whose velocities change as those of `velocities` do.
    pub(crate) fn new(begin: &State<V, T>, velocities: &Increment<V, T>, step: T) -> Self {
        let half: T = nalgebra::convert(0.5);
        let mut increment = velocities.velocities_only();
        increment.rotation = (begin.angular_velocity + velocities.angular_velocity * half) * step;
        increment.modal_coordinates = begin.modal_rates.clone();
        increment.modal_coordinates.add_scaled(half, &velocities.modal_rates);
        increment.modal_coordinates.scale(step);
        let orientation = turned(&begin.orientation, &increment.rotation);
        let (first, last) = (matrix(&begin.orientation), matrix(&orientation));
        let mean_rotation = (first + last) * half;
        let velocity = begin.velocity + velocities.velocity;
        let mean_velocity = (first.tr_mul(&begin.velocity) + last.tr_mul(&velocity)) * half;
        increment.position = mean_rotation * mean_velocity * step;
        let end = begin.retract(&increment);
        let mut middle = begin.clone();
        let mut half_way = increment.clone();
        half_way.scale(half);
        middle = middle.retract(&half_way);
        middle.orientation = half_way_orientation(&begin.orientation, &end.orientation);
        let turn = begin.to_inertial(&increment.rotation);
        Self { begin: begin.clone(), end, middle, increment, mean_rotation, turn, step }
    }

    /// The change of the places over the step, and a correction of the velocities at its end.
    pub(crate) fn with_correction(&self, correction: &Motion<V, T>) -> Increment<V, T> {
        Increment {
            velocity: self.end.to_inertial(&correction.linear),
            angular_velocity: correction.angular,
            modal_rates: correction.modal.clone(),
            ..self.increment.clone()
        }
    }

    /// Āᵀ times an inertial vector.
    pub(crate) fn to_mean(&self, inertial: &Vector3<T>) -> Vector3<T> {
        self.mean_rotation.tr_mul(inertial)
    }

    /// A force in components of the middle's frame, in those dual to w̄.
    pub(crate) fn dual_to_mean(&self, force: GeneralisedForce<V, T>) -> GeneralisedForce<V, T> {
        GeneralisedForce {
            force: self.to_mean(&self.middle.to_inertial(&force.force)),
            moment: self.to_mean(&self.middle.to_inertial(&force.moment)),
            modal: force.modal,
        }
    }

    /// The force of uniform gravity whose work is the change of potential energy. `gravity`: m/s², inertial.
    pub(crate) fn weight<B>(&self, body: &B, gravity: &Vector3<T>) -> GeneralisedForce<V, T>
    where
        B: FlexibleBody<T, Modal = V>,
    {
        let q = &self.middle.modal_coordinates;
        let prepared = body.prepare(q, &Vector3::zeros(), &body.undeformed());
        let mut weight = prepared.gravity_force(&self.to_mean(gravity));
        let arm = self.mean_rotation * prepared.first_moment;
        weight.moment = self.to_mean(&arm.cross(gravity));
        weight
    }

    /// What is missing in the equations of the step with `force`, times h, and the matrix that a correction needs.
    ///
    /// `None` if the modal mass with the implicit terms is not positive definite.
    pub(crate) fn stage<B>(
        &self,
        body: &B,
        force: &GeneralisedForce<V, T>,
    ) -> Option<(ImplicitBody<V, T>, GeneralisedForce<V, T>)>
    where
        B: FlexibleBody<T, Modal = V>,
    {
        let half: T = nalgebra::convert(0.5);
        let ([linear, linear_end], [angular, angular_end], modal) = self.momenta(body);
        let mut missing = force.clone();
        let q = &self.middle.modal_coordinates;
        let mut rates = self.begin.modal_rates.clone();
        rates.add_scaled(T::one(), &self.end.modal_rates);
        rates.scale(half);
        missing.modal.add_scaled(-T::one(), &body.internal_force(q, &rates));
        missing.modal.add_scaled(T::one(), &self.shape_force(body));
        missing.scale(self.step);
        missing.force -= self.to_mean(&(linear_end - linear));
        let carried = self.increment.position.cross(&((linear + linear_end) * half));
        missing.moment -= self.to_mean(&(angular_end - angular + carried));
        missing.modal.add_scaled(-T::one(), &modal);
        Some((ImplicitBody::new(body, &self.middle, self.step * half)?, missing))
    }

    /// Linear and angular momentum (inertial, about the frame origin) at both ends, and the change of the modal ones.
    fn momenta<B>(&self, body: &B) -> ([Vector3<T>; 2], [Vector3<T>; 2], V)
    where
        B: FlexibleBody<T, Modal = V>,
    {
        let of = |state: &State<V, T>| {
            let prepared =
                body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
            let momentum = prepared.mass_times(&body.modal_mass(), &velocities(state));
            let rotation = matrix(&state.orientation);
            (rotation * momentum.force, rotation * momentum.moment, momentum.modal)
        };
        let (first, last) = (of(&self.begin), of(&self.end));
        let mut change = last.2;
        change.add_scaled(-T::one(), &first.2);
        ([first.0, last.0], [first.1, last.1], change)
    }

    /// ½ w_0ᵀ M'(q̄) w_1, the derivative of the kinetic energy to the modal coordinates, from the quadratic velocity vector.
    fn shape_force<B>(&self, body: &B) -> V
    where
        B: FlexibleBody<T, Modal = V>,
    {
        let q = &self.middle.modal_coordinates;
        let (first, last) = (velocities(&self.begin), velocities(&self.end));
        let none = body.undeformed();
        let [mut sum, mut difference] = [last.modal.clone(), last.modal.clone()];
        sum.add_scaled(T::one(), &first.modal);
        difference.add_scaled(-T::one(), &first.modal);
        // with Q_μ = 2 ω · ϑ_νμ q̇_ν - ½ ω · Θ'_μ ω, the form is -½ (Q(ω, q̇) + Q(ω, 0)); its polar form by four values of Q
        let eighth: T = nalgebra::convert(0.125);
        let mut force = none.clone();
        for (sign, angular, modal) in [
            (-eighth, last.angular + first.angular, &sum),
            (-eighth, last.angular + first.angular, &none),
            (eighth, last.angular - first.angular, &difference),
            (eighth, last.angular - first.angular, &none),
        ] {
            force.add_scaled(sign, &body.prepare(q, &angular, modal).quadratic_velocity.modal);
        }
        // and u · (ω × m b_μ), which the quadratic velocity vector does not have
        let half: T = nalgebra::convert(0.5);
        let turning = (first.angular.cross(&last.linear) + last.angular.cross(&first.linear)) * half;
        let rows = body.prepare(q, &Vector3::zeros(), &none).modal_first_moment;
        for (row, component) in rows.iter().zip(turning.iter()) {
            force.add_scaled(-*component, row);
        }
        if body.is_stiffened() {
            self.add_stiffening_force(body, &mut force);
        }
        force
    }

    /// What geometric stiffness adds to [`Self::shape_force`]: with Θ_rf = ... + H q and m B = ... + C q, both symmetric in the
    /// modes, ω · H q̇ + u · C q̇. The quadratic velocity vector, which takes the halves of Lagrange's derivative together, has
    /// neither: Θ_rf(q + q̇) - Θ_rf(q) = [ϑ_νμ q̇_ν] + H q̇, and 2 ω · ϑ_νμ q̇_ν is in Q.
    fn add_stiffening_force<B>(&self, body: &B, force: &mut V)
    where
        B: FlexibleBody<T, Modal = V>,
    {
        let q = &self.middle.modal_coordinates;
        let (first, last) = (velocities(&self.begin), velocities(&self.end));
        let none = body.undeformed();
        let half: T = nalgebra::convert(0.5);
        let here = body.prepare(q, &Vector3::zeros(), &none);
        for (one, other) in [(&first, &last), (&last, &first)] {
            let mut moved = q.clone();
            moved.add_scaled(T::one(), &other.modal);
            let there = body.prepare(&moved, &Vector3::zeros(), &none);
            for axis in 0..3 {
                for (sign, prepared) in [(half, &there), (-half, &here)] {
                    let (turn, shift) = (one.angular[axis] * sign, one.linear[axis] * sign);
                    force.add_scaled(turn, &prepared.rotation_modal_coupling[axis]);
                    force.add_scaled(shift, &prepared.modal_first_moment[axis]);
                }
            }
            let quarter = half * half;
            for (sign, rates) in [(-quarter, &other.modal), (quarter, &none)] {
                force.add_scaled(sign, &body.prepare(q, &one.angular, rates).quadratic_velocity.modal);
            }
        }
    }
}

fn velocities<V: ModalVector<T>, T: RealField + Copy>(state: &State<V, T>) -> Motion<V, T> {
    Motion {
        linear: matrix(&state.orientation).tr_mul(&state.velocity),
        angular: state.angular_velocity,
        modal: state.modal_rates.clone(),
    }
}

pub(super) fn matrix<T: RealField + Copy>(orientation: &UnitQuaternion<T>) -> Matrix3<T> {
    orientation.to_rotation_matrix().into_inner()
}

/// The orientation half way between two that are less than half a turn apart.
pub(crate) fn half_way_orientation<T: RealField + Copy>(
    first: &UnitQuaternion<T>,
    last: &UnitQuaternion<T>,
) -> UnitQuaternion<T> {
    let sign = if first.coords.dot(&last.coords) < T::zero() { -T::one() } else { T::one() };
    let sum = first.quaternion() + last.quaternion() * sign;
    let norm = sum.norm();
    if norm > T::zero() { UnitQuaternion::new_unchecked(sum / norm) } else { *first }
}

/// The rotation vector whose Cayley map, before the first orientation, makes the last one. Frame: inertial.
pub(crate) fn turn_between<T: RealField + Copy>(
    first: &UnitQuaternion<T>,
    last: &UnitQuaternion<T>,
) -> Vector3<T> {
    let two: T = nalgebra::convert(2.0);
    let relative = last * first.inverse();
    relative.imag() * (two / relative.w)
}
