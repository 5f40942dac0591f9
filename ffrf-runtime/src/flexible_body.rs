//! What every generated body can do.

use nalgebra::{RealField, SMatrix, SVector, Vector3};

use crate::Marker;

/// Mass matrix, quadratic velocity vector and accelerations of one state, from one pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EquationsOfMotion<const M: usize, const N: usize, T = f64> {
    /// Mass matrix M(q). Shape: N x N.
    pub mass_matrix: SMatrix<T, N, N>,
    /// Quadratic velocity vector Q(q, ω, q̇). Shape: N.
    pub quadratic_velocity: SVector<T, N>,
    /// Accelerations [α; ω̇; q̈]. Shape: N.
    pub acceleration: SVector<T, N>,
}

/// A flexible body with `M` modes and `N` = 6 + `M` velocities, in the scalar type `T`.
///
/// Unknowns are w = [α; ω̇; q̈]: acceleration of the frame origin (inertial, resolved in the body frame),
/// angular acceleration (body frame) and modal accelerations, with
/// `M(q) w + Q(q, ω, q̇) + [0; 0; K q + D q̇] = force`.
/// Every vector is resolved in the body frame. No method allocates or panics.
pub trait FlexibleBody<const M: usize, const N: usize, T = f64> {
    /// Mass matrix M(q). Shape: N x N, symmetric. Source: (203), body-resolved.
    fn mass_matrix(&self, q: &SVector<T, M>) -> SMatrix<T, N, N>;
    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Shape: N. Source: (209), corrected.
    fn quadratic_velocity(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> SVector<T, N>;
    /// Accelerations [α; ω̇; q̈] under `force`, elastic and damping forces included. Shape: N.
    ///
    /// q̈ is eliminated first; the dense mass matrix is never formed.
    fn forward_dynamics(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> SVector<T, N>;
    /// Mass matrix, quadratic velocity vector and accelerations in one pass.
    fn equations_of_motion(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> EquationsOfMotion<M, N, T>;
    /// [`FlexibleBody::equations_of_motion`] into given places: with many modes, moving the matrix costs as much
    /// as computing it.
    #[allow(clippy::too_many_arguments)] // inputs and outputs, each in its place
    fn write_equations_of_motion(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
        mass_matrix: &mut SMatrix<T, N, N>,
        quadratic_velocity: &mut SVector<T, N>,
        acceleration: &mut SVector<T, N>,
    ) {
        let equations = self.equations_of_motion(q, omega, q_dot, force);
        *mass_matrix = equations.mass_matrix;
        *quadratic_velocity = equations.quadratic_velocity;
        *acceleration = equations.acceleration;
    }
    /// Kinetic energy; `velocity` is that of the frame origin. Units: J.
    fn kinetic_energy(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> T;
    /// Elastic energy ½ qᵀ K q. Units: J.
    fn elastic_energy(&self, q: &SVector<T, M>) -> T;
    /// Linear momentum. Shape: 3. Units: N s.
    fn linear_momentum(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T>;
    /// Angular momentum about the frame origin. Shape: 3. Units: N m s.
    fn angular_momentum(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T>;
    /// Elastic and damping forces K q + D q̇, on the left-hand side. Shape: M.
    fn internal_force(&self, q: &SVector<T, M>, q_dot: &SVector<T, M>) -> SVector<T, M>;
    /// Generalised force of uniform gravity g (body-resolved). Shape: N.
    fn gravity_force(&self, q: &SVector<T, M>, gravity: &Vector3<T>) -> SVector<T, N>;
    /// Modal stiffness K_ff. Shape: M x M.
    fn stiffness_matrix(&self) -> SMatrix<T, M, M>;
    /// Modal damping D_ff. Shape: M x M.
    fn damping_matrix(&self) -> SMatrix<T, M, M>;

    /// Mass m, by default the weight in a unit field. Units: kg.
    fn mass(&self) -> T
    where
        T: RealField + Copy,
    {
        self.gravity_force(&SVector::zeros(), &Vector3::x())[0]
    }

    /// First moment of mass m r(q) about the frame origin, by default from the moments of two unit fields.
    ///
    /// Shape: 3. Units: kg m. Frame: body. Source: (204), r = a + q_μ b_μ.
    fn first_mass_moment(&self, q: &SVector<T, M>) -> Vector3<T>
    where
        T: RealField + Copy,
    {
        // m r × e1 = m (0, r3, -r2) and m r × e2 = m (-r3, 0, r1)
        let along_x = self.gravity_force(q, &Vector3::x());
        let along_y = self.gravity_force(q, &Vector3::y());
        Vector3::new(along_y[5], -along_x[5], along_x[4])
    }

    /// The names of the markers in the model. Generated bodies have each marker as a constant as well.
    fn marker_names(&self) -> &'static [&'static str] {
        &[]
    }

    /// The marker called `name`, or `None`. A search by name: look markers up before the simulation starts.
    fn marker(&self, name: &str) -> Option<Marker<M, T>> {
        let _ = name;
        None
    }

    /// Position of a marker from the frame origin, see [`Marker::position`]. Shape: 3. Units: m. Frame: body.
    fn marker_position(&self, marker: &Marker<M, T>, q: &SVector<T, M>) -> Vector3<T>
    where
        T: RealField + Copy,
    {
        marker.position(q)
    }

    /// Velocity of a marker, see [`Marker::velocity`]. Shape: 3. Units: m/s. Frame: body.
    fn marker_velocity(
        &self,
        marker: &Marker<M, T>,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T>
    where
        T: RealField + Copy,
    {
        marker.velocity(q, velocity, omega, q_dot)
    }

    /// Generalised force of a force (body-resolved) at a marker, see [`Marker::force`]. Shape: N.
    fn marker_force(&self, marker: &Marker<M, T>, q: &SVector<T, M>, force: &Vector3<T>) -> SVector<T, N>
    where
        T: RealField + Copy,
    {
        marker.force(q, force)
    }

    /// Generalised force of a moment (body-resolved) at a marker, see [`Marker::moment`]. Shape: N.
    fn marker_moment(&self, marker: &Marker<M, T>, moment: &Vector3<T>) -> SVector<T, N>
    where
        T: RealField + Copy,
    {
        marker.moment(moment)
    }
}
