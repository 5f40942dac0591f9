//! One scalar constraint between two markers, at position, velocity and acceleration level.

use nalgebra::{RealField, Vector3};

use crate::body::{MarkerMotion, Wrench};
use crate::six::{Square, add_scaled, zeros};

/// A scalar relation g = 0 between two markers with the derivatives that follow from it.
///
/// ```text
/// ġ = first · [v; ω]_first + second · [v; ω]_second + rate
/// g̈ = first · [v̇; ω̇]_first + second · [v̇; ω̇]_second + bias
/// ```
///
/// Frame of all vectors: inertial. The residual is the single truth; tests derive the rest from it by dual numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<T = f64> {
    /// g. Units: m or rad.
    pub residual: T,
    /// Gradient to the velocities of the first marker.
    pub first: Wrench<T>,
    /// Gradient to the velocities of the second marker.
    pub second: Wrench<T>,
    /// Partial derivative of g to time. Units: m/s or rad/s.
    pub rate: T,
    /// What g̈ has besides accelerations. Units: m/s² or rad/s².
    pub bias: T,
}

impl<T: RealField + Copy> Row<T> {
    /// A row without any effect.
    pub fn zero() -> Self {
        let zero = T::zero();
        Self { residual: zero, first: Wrench::zero(), second: Wrench::zero(), rate: zero, bias: zero }
    }

    /// ġ in the motion of both markers.
    pub fn velocity(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        self.first.power(&first.velocity, &first.angular_velocity)
            + self.second.power(&second.velocity, &second.angular_velocity)
            + self.rate
    }

    /// What g̈ has besides the accelerations of the bodies: the bias and that of both markers.
    pub fn whole_bias(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        self.first.power(&first.acceleration_bias, &first.angular_acceleration_bias)
            + self.second.power(&second.acceleration_bias, &second.angular_acceleration_bias)
            + self.bias
    }
}

/// The most rows that one joint has.
pub const MOST_ROWS: usize = 6;

/// The rows of one joint, each kind of number of all rows side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rows<T = f64> {
    residual: [T; MOST_ROWS],
    rate: [T; MOST_ROWS],
    bias: [T; MOST_ROWS],
    /// Components of force and moment of all rows, at the first and at the second end.
    gradients: [Square<T>; 2],
    count: usize,
}

impl<T: RealField + Copy> Rows<T> {
    /// No rows.
    pub fn none() -> Self {
        let none = [T::zero(); MOST_ROWS];
        Self { residual: none, rate: none, bias: none, gradients: [zeros(); 2], count: 0 }
    }

    /// Forgets the rows, to be evaluated anew: a joint has as many in every state.
    pub(crate) fn restart(&mut self) {
        self.count = 0;
    }

    /// Adds a row; beyond [`MOST_ROWS`] it is left out, which no joint reaches.
    #[inline]
    pub fn push(&mut self, row: Row<T>) {
        let count = self.count;
        if count >= MOST_ROWS {
            return;
        }
        self.residual[count] = row.residual;
        self.rate[count] = row.rate;
        self.bias[count] = row.bias;
        for (components, wrench) in self.gradients.iter_mut().zip([&row.first, &row.second]) {
            let [x, y, z, r_x, r_y, r_z] = components;
            [x[count], y[count], z[count]] = wrench.force.into();
            [r_x[count], r_y[count], r_z[count]] = wrench.moment.into();
        }
        self.count += 1;
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The rows, one by one.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Row<T>> + '_ {
        (0..self.count.min(MOST_ROWS)).map(|row| Row {
            residual: self.residual[row],
            first: self.wrench(0, row),
            second: self.wrench(1, row),
            rate: self.rate[row],
            bias: self.bias[row],
        })
    }

    fn wrench(&self, end: usize, row: usize) -> Wrench<T> {
        let [x, y, z, r_x, r_y, r_z] = self.gradients[end].map(|component| component[row]);
        Wrench { force: Vector3::new(x, y, z), moment: Vector3::new(r_x, r_y, r_z) }
    }

    /// g of all rows; zero beyond their number.
    pub(crate) fn residuals(&self) -> &[T; MOST_ROWS] {
        &self.residual
    }

    /// Puts other numbers in the place of g of all rows.
    pub(crate) fn set_residuals(&mut self, residuals: [T; MOST_ROWS]) {
        self.residual = residuals;
    }

    /// The components of force and moment of all rows at both ends. Shape: 6 x rows each.
    pub(crate) fn gradients(&self) -> &[Square<T>; 2] {
        &self.gradients
    }

    /// ġ of all rows, see [`Row::velocity`].
    pub(crate) fn velocities(&self, ends: &[MarkerMotion<T>; 2]) -> [T; MOST_ROWS] {
        let mut sum = self.rate;
        for (components, end) in self.gradients.iter().zip(ends) {
            add_powers(&mut sum, components, &end.velocity, &end.angular_velocity);
        }
        sum
    }

    /// What g̈ of all rows has besides the accelerations of the bodies, see [`Row::whole_bias`].
    pub(crate) fn whole_biases(&self, ends: &[MarkerMotion<T>; 2]) -> [T; MOST_ROWS] {
        let mut sum = self.bias;
        for (components, end) in self.gradients.iter().zip(ends) {
            add_powers(&mut sum, components, &end.acceleration_bias, &end.angular_acceleration_bias);
        }
        sum
    }
}

/// Adds the products of the gradients of all rows with velocities.
#[inline]
pub(crate) fn add_powers<T: RealField + Copy>(
    sum: &mut [T; MOST_ROWS],
    components: &Square<T>,
    velocity: &Vector3<T>,
    angular_velocity: &Vector3<T>,
) {
    let velocities = velocity.iter().chain(angular_velocity.iter());
    for (component, velocity) in components.iter().zip(velocities) {
        add_scaled(sum, *velocity, component);
    }
}

/// The axes of a triad. Frame: inertial.
pub(crate) fn axes<T: RealField + Copy>(motion: &MarkerMotion<T>) -> [Vector3<T>; 3] {
    let axes = motion.axes();
    [axes.column(0).into(), axes.column(1).into(), axes.column(2).into()]
}
