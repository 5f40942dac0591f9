//! A frame of point masses with two modes whose Θ_ff, K_ff and D_ff are dense, and whose modes move the centre of mass.

use ffrf::nalgebra::{Matrix2, Matrix3, SMatrix, Vector2, Vector3};
use ffrf::{DenseForms, FlexibleBody, GeneralisedForce, Marker, ModalMatrix, Observables, Prepared};

type Two = Vector2<f64>;
type Rows = SMatrix<f64, 3, 2>;

/// Five points, each with its mass and the marker that moves as it does.
#[derive(Clone, Copy)]
pub struct PointMasses(pub [(f64, Marker<Two>); 5]);

impl PointMasses {
    pub fn new() -> Self {
        let point = |x, y, z, translation: [[f64; 2]; 3]| Marker {
            position: Vector3::new(x, y, z),
            translation: translation.map(Two::from),
            rotation: [[0.1, 0.0], [0.0, -0.2], [0.3, 0.1]].map(Two::from),
            stressing: None,
        };
        Self([
            (1.0, point(0.5, 0.1, 0.0, [[0.0, 0.1], [0.4, 0.0], [0.0, 0.3]])),
            (1.5, point(-0.4, 0.2, 0.1, [[0.2, 0.0], [-0.3, 0.1], [0.1, 0.0]])),
            (0.7, point(0.1, -0.6, 0.3, [[0.0, 0.5], [0.1, 0.2], [-0.2, 0.1]])),
            (1.2, point(0.0, 0.3, -0.5, [[0.3, -0.1], [0.0, 0.4], [0.2, 0.0]])),
            (0.9, point(-0.2, -0.1, 0.6, [[-0.1, 0.2], [0.2, 0.0], [0.0, -0.5]])),
        ])
    }
}

fn rows(marker: &Marker<Two>) -> Rows {
    let [x, y, z] = marker.translation;
    Rows::from_rows(&[x.transpose(), y.transpose(), z.transpose()])
}

impl FlexibleBody for PointMasses {
    type Modal = Two;

    fn undeformed(&self) -> Two {
        Two::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<Two, f64> {
        let sum = self.0.iter().fold(Matrix2::zeros(), |sum, (mass, point)| {
            let rows = rows(point);
            sum + rows.tr_mul(&rows) * *mass
        });
        ModalMatrix::Dense(sum)
    }

    fn stiffness(&self) -> ModalMatrix<Two, f64> {
        ModalMatrix::Dense(Matrix2::new(90.0, 10.0, 10.0, 150.0))
    }

    fn damping(&self) -> ModalMatrix<Two, f64> {
        ModalMatrix::Dense(Matrix2::zeros())
    }

    fn prepare(&self, q: &Two, omega: &Vector3<f64>, q_dot: &Two) -> Prepared<Two> {
        let mut total = 0.0;
        let mut moment = Vector3::zeros();
        let mut inertia = Matrix3::zeros();
        let (mut translation, mut rotation) = (Rows::zeros(), Rows::zeros());
        let mut velocity_force = GeneralisedForce::zeros(q);
        for (mass, point) in &self.0 {
            let (arm, rows) = (point.position(q), rows(point));
            total += mass;
            moment += arm * *mass;
            inertia += (Matrix3::from_diagonal_element(arm.norm_squared()) - arm * arm.transpose()) * *mass;
            translation += rows * *mass;
            rotation += arm.cross_matrix() * rows * *mass;
            // the acceleration of the point at α = ω̇ = q̈ = 0
            let bias = omega.cross(&(omega.cross(&arm) + rows * q_dot * 2.0));
            velocity_force.add_scaled(1.0, &point.force(q, &(bias * *mass)));
        }
        let split = |rows: &Rows| [0, 1, 2].map(|axis| Two::new(rows[(axis, 0)], rows[(axis, 1)]));
        Prepared {
            mass: total,
            first_moment: moment,
            inertia,
            modal_first_moment: split(&translation),
            rotation_modal_coupling: split(&rotation),
            quadratic_velocity: velocity_force,
            internal_force: self.internal_force(q, q_dot),
        }
    }
}

impl Observables for PointMasses {}
impl DenseForms<2, 8> for PointMasses {}
