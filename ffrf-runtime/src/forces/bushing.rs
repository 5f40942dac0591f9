//! A bushing: springs and dampers along and about the axes of a triad.

use nalgebra::{RealField, Vector3};

use super::{ForceElement, SoftRow};
use crate::body::{MarkerMotion, MarkerStep, Wrench};

/// Of 1 + trace, which is four at no turn and zero at half a turn.
const NEAR_HALF_TURN: f64 = 1e-3;

/// A bushing: displacement of the second triad in the first, and twice the vector part u of the quaternion between both, which
/// is the rotation vector to second order. Forces are the exact gradient of the energy ½ Σ k d² + ½ Σ c (2 u)².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bushing<T = f64> {
    /// Stiffness along x, y, z, then about them. Units: N/m and N m/rad.
    pub stiffness: [T; 6],
    /// Damping along x, y, z, then about them. Units: N s/m and N m s/rad.
    pub damping: [T; 6],
}

impl<T: RealField + Copy> ForceElement<T> for Bushing<T> {
    /// Wrenches on both ends (inertial). Force and moment act at the second end; the first gets their reaction there.
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let between = second.position - first.position;
        let to_first = |vector: &Vector3<T>| first.orientation.inverse_transform_vector(vector);
        let displacement = to_first(&between);
        // seen from the first triad, which turns
        let velocity = to_first(&(second.velocity - first.velocity - first.angular_velocity.cross(&between)));
        let relative = relative_rotation(first, second);
        let spin = to_first(&(second.angular_velocity - first.angular_velocity));
        let [k_x, k_y, k_z, c_x, c_y, c_z] = self.stiffness;
        let [d_x, d_y, d_z, e_x, e_y, e_z] = self.damping;
        let force = displacement.component_mul(&Vector3::new(k_x, k_y, k_z))
            + velocity.component_mul(&Vector3::new(d_x, d_y, d_z));
        // the gradient of the stored energy, exact for every turn: u̇ = ½ (s ω + ω × u)
        let (s, u) = (relative.w, relative.imag());
        let two: T = nalgebra::convert(2.0);
        let restoring = u.component_mul(&Vector3::new(c_x, c_y, c_z)) * two;
        let moment = restoring * s + u.cross(&restoring) + spin.component_mul(&Vector3::new(e_x, e_y, e_z));
        let (force, moment) =
            (first.orientation.transform_vector(&force), first.orientation.transform_vector(&moment));
        [Wrench { force, moment: moment + between.cross(&force) }, Wrench { force: -force, moment: -moment }]
    }

    /// The energy is ½ Σ k_i (a_i · b)² + ½ Σ c_i v_i² / (1 + t), with the axes a_i of the first triad and v, t twice the axial
    /// vector and the trace of the matrix of products a_i · a'_j: all changes are those of products, exactly. Near half a turn,
    /// where t is -1, it acts as in the means.
    fn wrenches_over(&self, first: &MarkerStep<T>, second: &MarkerStep<T>) -> [Wrench<T>; 2] {
        let ends = [0, 1].map(|k| Turn::of(&first.ends[k], &second.ends[k]));
        let [begin, end] = &ends;
        let least: T = nalgebra::convert(NEAR_HALF_TURN);
        if begin.spread <= least || end.spread <= least {
            return self.wrenches(&first.mean, &second.mean);
        }
        let half: T = nalgebra::convert(0.5);
        let [k_x, k_y, k_z, c_x, c_y, c_z] = self.stiffness;
        let [d_x, d_y, d_z, e_x, e_y, e_z] = self.damping;
        let (axes, others) = (first.mean.axes(), second.mean.axes());
        let between = second.mean.position - first.mean.position;
        let displacement =
            [0, 1].map(|k| first.ends[k].axes().tr_mul(&(second.ends[k].position - first.ends[k].position)));
        let velocity =
            second.mean.velocity - first.mean.velocity - first.mean.angular_velocity.cross(&between);
        let force = axes
            * (((displacement[0] + displacement[1]) * half).component_mul(&Vector3::new(k_x, k_y, k_z))
                + axes.tr_mul(&velocity).component_mul(&Vector3::new(d_x, d_y, d_z)));
        let stiffness = Vector3::new(c_x, c_y, c_z);
        let share = (T::one() / begin.spread + T::one() / end.spread) * half;
        let on_axial = ((begin.axial + end.axial) * half).component_mul(&stiffness) * share;
        let squares = (begin.axial.component_mul(&begin.axial) + end.axial.component_mul(&end.axial)) * half;
        let on_trace = -squares.dot(&stiffness) * half / (begin.spread * end.spread);
        let spin = axes.tr_mul(&(second.mean.angular_velocity - first.mean.angular_velocity));
        let mut moment = axes * spin.component_mul(&Vector3::new(e_x, e_y, e_z));
        for i in 0..3 {
            let (next, last) = ((i + 1) % 3, (i + 2) % 3);
            let change = |i: usize, j: usize| -> Vector3<T> { others.column(j).cross(&axes.column(i)) };
            moment += (change(last, next) - change(next, last)) * on_axial[i] + change(i, i) * on_trace;
        }
        [Wrench { force, moment: moment + between.cross(&force) }, Wrench { force: -force, moment: -moment }]
    }

    /// Six: along and about the axes of the first triad, with the stiffness of small turns.
    fn soften(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, push: &mut dyn FnMut(SoftRow<T>)) {
        let between = second.position - first.position;
        let axes = first.axes();
        let zero = Vector3::zeros();
        for (row, (stiffness, damping)) in self.stiffness.into_iter().zip(self.damping).enumerate() {
            let axis: Vector3<T> = axes.column(row % 3).into();
            let (on_first, on_second) = if row < 3 {
                // the rate is that seen from the first triad, which turns
                ((-axis, -between.cross(&axis)), (axis, zero))
            } else {
                ((zero, -axis), (zero, axis))
            };
            let [first, second] = [on_first, on_second].map(|(force, moment)| Wrench { force, moment });
            push(SoftRow { first, second, stiffness, damping });
        }
    }

    /// Stored energy. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let displacement = first.orientation.inverse_transform_vector(&(second.position - first.position));
        let two: T = nalgebra::convert(2.0);
        let turn = relative_rotation(first, second).imag() * two;
        let squares = displacement.iter().chain(turn.iter()).zip(self.stiffness);
        let sum = squares.fold(T::zero(), |sum, (value, stiffness)| sum + *value * *value * stiffness);
        sum * nalgebra::convert(0.5)
    }
}

/// The quaternion (s, u) from the first to the second triad, of either sign: all that is made of it has products of two of its
/// numbers. Frame: the first triad.
fn relative_rotation<T: RealField + Copy>(
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
) -> nalgebra::Quaternion<T> {
    (first.orientation.inverse() * second.orientation).into_inner()
}

/// What the energy of turning depends on.
struct Turn<T> {
    /// Twice the axial vector of the matrix of products of axes.
    axial: Vector3<T>,
    /// One and its trace.
    spread: T,
}

impl<T: RealField + Copy> Turn<T> {
    fn of(first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> Self {
        let products = first.axes().tr_mul(&second.axes());
        Self {
            axial: Vector3::new(
                products[(2, 1)] - products[(1, 2)],
                products[(0, 2)] - products[(2, 0)],
                products[(1, 0)] - products[(0, 1)],
            ),
            spread: T::one() + products.trace(),
        }
    }
}
