//! Modes that are nearly a combination of each other.

use ffrf::nalgebra::Vector3;
use ffrf::{FlexibleBody, FreeBody, ModalVector};

use crate::row;
use crate::settings::largest;
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::same_span;
use crate::two_masses::{kernels, modal, of_points};

pub fn section() -> Section {
    let rows = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-9, 0.0];
    Section {
        title: "Nearly dependent modes",
        text: "Two modes φ₁ and φ₁ + ε φ₂ of eight point masses span what φ₁ and φ₂ span: the motion of the frame must be the \
               same. Accelerations of the turning, vibrating body: distance from those with φ₁ and φ₂, relative. The condition \
               of the mass matrix is 1/ε²; a model beyond 1e10 is refused, and beyond 5e5 the generator \
               refuses single precision. The condition is measured as the least share of the kinetic energy of some combination \
               of modes that nothing else expresses.",
        rows: rows.iter().map(|epsilon| row!(format!("ε = {epsilon:.0e}"), nearly, *epsilon)).collect(),
    }
}

fn nearly<T: Real>(epsilon: f64) -> Figure {
    let mut random = ffrf_test_kit::random::Random::new(3);
    let mut field = || (0..8).map(|_| [0, 1, 2].map(|_| random.number())).collect::<Vec<[f64; 3]>>();
    let (positions, first, second) = (field(), field(), field());
    let masses = [1.0; 8];
    let mixed: Vec<[f64; 3]> =
        first.iter().zip(&second).map(|(a, b)| [0, 1, 2].map(|i| a[i] + epsilon * b[i])).collect();
    // K = diag(100, 300) of φ₁ and φ₂
    let plain =
        of_points(&positions, &masses, &[first.clone(), second], vec![vec![100.0, 0.0], vec![0.0, 300.0]]);
    let near = of_points(
        &positions,
        &masses,
        &[first, mixed],
        vec![vec![100.0, 100.0], vec![100.0, 100.0 + 300.0 * epsilon * epsilon]],
    );
    let (plain, near) = match (kernels::<f64>(&plain), kernels::<T>(&near)) {
        (Ok(plain), Ok(near)) => (plain, near),
        (_, Err(error)) | (Err(error), _) => return refused(error),
    };
    // q₁ φ₁ + q₂ φ₂ = (q₁ - q₂/ε) φ₁ + q₂/ε (φ₁ + ε φ₂): only φ₁ is deformed, so that no coordinate is large
    let (q, rates) = ([0.01, 0.0], [0.3, 0.0]);
    let spin = Vector3::new(1.0, -2.0, 3.0);
    let exact = plain.forward_dynamics(
        &modal(&q),
        &spin,
        &modal(&rates),
        &ffrf::GeneralisedForce::zeros(&plain.undeformed()),
    );
    let body = FreeBody::new(near).with_spin(spin.map(T::of)).with_deformation(modal(&q), modal(&rates));
    let mut stepped = body.clone();
    if let Err(error) = stepped.step_rk4(T::of(1e-6), &()) {
        return refused(error);
    }
    let found = body.acceleration(&());
    let frame = (found.linear.map(T::double) - exact.linear).norm() / exact.linear.norm();
    let turning = (found.angular.map(T::double) - exact.angular).norm() / exact.angular.norm();
    assert!(found.modal.all_finite());
    below::<T>(largest([frame, turning]), same_span(epsilon))
}
