//! One check per function, for generated code. Errors: [`InvariantError`]. Panics: never.

use nalgebra::SMatrix;

use super::entries::{Entries, Square};
use super::pivots::first_bad_pivot;
use super::tolerances::{AGREEMENT, INDEPENDENCE, NEGATIVE, RIGID, limit};
use super::{InvariantError, InvariantExpectation, InvariantIndex};
use crate::math::{columns, square_root};

/// What the layout says about the transpose of a 3 x 3 matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mirror {
    /// Nothing.
    Dense,
    /// It is the same; a diagonal matrix is symmetric as well.
    Symmetric,
    /// It is the negative.
    Antisymmetric,
}

/// What the layout says about Θ_ff.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModalMass {
    /// It is the identity.
    Identity,
    /// It is diagonal.
    Diagonal,
    /// It is symmetric.
    Symmetric,
}

const HERE: InvariantIndex = InvariantIndex::EMPTY;

/// Every number is finite.
pub fn finite(field: &'static str, entries: &impl Entries) -> Result<(), InvariantError> {
    match entries.non_finite(HERE) {
        Some((index, found)) => {
            Err(InvariantError { field, index, found, expected: InvariantExpectation::Finite })
        }
        None => Ok(()),
    }
}

/// m > 0.
pub fn mass(mass: impl Into<f64>) -> Result<(), InvariantError> {
    let found = mass.into();
    if found > 0.0 {
        return Ok(());
    }
    Err(InvariantError { field: "mass", index: HERE, found, expected: InvariantExpectation::Positive })
}

/// T is symmetric and positive semidefinite, its inertia tensor tr(T) I - T positive definite. Returns tr T.
pub fn second_moment<S: Square<3>>(moment: &S) -> Result<f64, InvariantError> {
    let field = "second_moment";
    not_negative(field, moment)?;
    let entry = |i: usize, j: usize| moment.at(i, j);
    let trace = entry(0, 0) + entry(1, 1) + entry(2, 2);
    mirrored(field, HERE, moment, 1.0, trace)?;
    let shift = limit(NEGATIVE, S::EPSILON) * trace;
    definite::<3>(
        field,
        square(|i, j| entry(i, j) + if i == j { shift } else { 0.0 }),
        |_| 0.0,
        "T with a small share of its trace added: T is the integral of ρ x xᵀ and has no negative direction",
        |k| moment.place(HERE, k, k),
    )?;
    definite::<3>(
        field,
        square(|i, j| if i == j { trace - entry(i, i) } else { -entry(i, j) }),
        |_| limit(RIGID, S::EPSILON),
        "inertia tensor tr(T) I - T: all mass is on one line through the frame origin",
        |k| moment.place(HERE, k, k),
    )?;
    Ok(trace)
}

/// Θ_ff of mass-normalised modes, where no T_μν is supplied. Returns its diagonal.
pub fn unit_modal_mass<const M: usize>() -> [f64; M] {
    [1.0; M]
}

/// Θ_ff as a field of its own is symmetric and positive definite. Returns its diagonal.
pub fn modal_mass<const M: usize, S: Square<M>>(matrix: &S) -> Result<[f64; M], InvariantError> {
    let field = "modal_mass";
    mirrored(field, HERE, matrix, 1.0, largest(matrix))?;
    independent::<M>(field, S::EPSILON, square(|mu, nu| matrix.at(mu, nu)), |mu| matrix.place(HERE, mu, mu))?;
    Ok(core::array::from_fn(|mu| matrix.at(mu, mu)))
}

/// Θ_ff = [tr T_μν] is what the layout says, and positive definite. Returns its diagonal.
pub fn modal_mass_of_moments<const M: usize, S: Square<3>>(
    moments: &[[S; M]; M],
    layout: ModalMass,
) -> Result<[f64; M], InvariantError> {
    let field = "mode_mode_moment";
    let trace = |mu: usize, nu: usize| {
        let moment = &moments[mu.min(nu)][mu.max(nu)];
        moment.at(0, 0) + moment.at(1, 1) + moment.at(2, 2)
    };
    independent::<M>(field, S::EPSILON, square(trace), |mu| HERE.then(mu).then(mu))?;
    for mu in 0..M {
        for nu in mu..M {
            let (value, reason) = match layout {
                ModalMass::Identity if mu == nu => (1.0, "trace of T_μμ: the layout declares Θ_ff = I"),
                ModalMass::Identity => (0.0, "trace of T_μν: the layout declares Θ_ff = I"),
                ModalMass::Diagonal if mu != nu => (0.0, "trace of T_μν: the layout declares Θ_ff diagonal"),
                _ => continue,
            };
            let within = limit(AGREEMENT, S::EPSILON) * square_root(trace(mu, mu) * trace(nu, nu));
            agree(field, HERE.then(mu).then(nu), trace(mu, nu), value, within, reason)?;
        }
    }
    Ok(core::array::from_fn(|mu| trace(mu, mu)))
}

/// Each T_μ mirrors itself as the layout says; `modal_mass` is the diagonal of Θ_ff.
pub fn position_mode_moment<const M: usize, S: Square<3>>(
    moments: &[S; M],
    mirror: Mirror,
    second_moment_trace: f64,
    modal_mass: &[f64; M],
) -> Result<(), InvariantError> {
    for mu in 0..M {
        let size = square_root(second_moment_trace * modal_mass[mu]);
        structured("position_mode_moment", HERE.then(mu), &moments[mu], mirror, size)?;
    }
    Ok(())
}

/// T_νμ = T_μνᵀ, and each T_μν mirrors itself as the layout says; `modal_mass` is the diagonal of Θ_ff.
pub fn mode_mode_moment<const M: usize, S: Square<3>>(
    moments: &[[S; M]; M],
    mirror: Mirror,
    modal_mass: &[f64; M],
) -> Result<(), InvariantError> {
    let field = "mode_mode_moment";
    for mu in 0..M {
        for nu in mu..M {
            let size = square_root(modal_mass[mu] * modal_mass[nu]);
            let (read, other) = (&moments[mu][nu], &moments[nu][mu]);
            structured(field, HERE.then(mu).then(nu), read, mirror, size)?;
            let within = limit(AGREEMENT, S::EPSILON) * size;
            for i in 0..3 {
                for j in 0..3 {
                    let index = other.place(HERE.then(nu).then(mu), j, i);
                    agree(field, index, other.at(j, i), read.at(i, j), within, "T_νμ = T_μνᵀ")?;
                }
            }
        }
    }
    Ok(())
}

/// K_ff or D_ff: not negative on the diagonal, and symmetric.
pub fn modal_matrix<const M: usize, S: Square<M>>(
    field: &'static str,
    matrix: &S,
) -> Result<(), InvariantError> {
    not_negative(field, matrix)?;
    mirrored(field, HERE, matrix, 1.0, largest(matrix))
}

/// Γ_νμ = Γ_μν, for vectors (a diagonal stands for one) and for matrices.
pub fn load_stiffness<const M: usize, S: Square<3>>(
    field: &'static str,
    stiffness: &[[S; M]; M],
) -> Result<(), InvariantError> {
    let pairs = stiffness.as_flattened().iter();
    let size = pairs.fold(0.0, |most: f64, block| if largest(block) > most { largest(block) } else { most });
    let within = limit(AGREEMENT, S::EPSILON) * size;
    for mu in 0..M {
        for nu in mu..M {
            let (read, other) = (&stiffness[mu][nu], &stiffness[nu][mu]);
            for i in 0..3 {
                for j in 0..3 {
                    let index = other.place(HERE.then(nu).then(mu), i, j);
                    agree(field, index, other.at(i, j), read.at(i, j), within, "Γ_νμ = Γ_μν")?;
                }
            }
        }
    }
    Ok(())
}

/// The mass matrix at q = 0 is positive definite: first moments fit mass and inertia, and no mode is rigid motion or
/// follows from the modes before it. Row and column of the first that does not: translation 3, rotation 3, modes.
pub fn mass_matrix<const N: usize, T>(matrix: &SMatrix<T, N, N>) -> Result<(), InvariantError>
where
    [[T; N]; N]: Square<N>,
{
    let columns = columns(matrix);
    let epsilon = <[[T; N]; N] as Entries>::EPSILON;
    let least = |row: usize| limit(if row < 6 { RIGID } else { INDEPENDENCE }, epsilon);
    let reason = "mass matrix at q = 0: rows 3 to 5, the first moment is too large for mass and inertia or all mass is \
                  on a line; rows from 6, a mode is rigid motion or a combination of modes before it";
    definite::<N>("mass_matrix", square(|i, j| columns.at(i, j)), least, reason, |k| HERE.then(k).then(k))
}

/// Θ_ff is positive definite.
fn independent<const M: usize>(
    field: &'static str,
    epsilon: f64,
    matrix: [[f64; M]; M],
    place: impl Fn(usize) -> InvariantIndex,
) -> Result<(), InvariantError> {
    let reason = "modal mass Θ_ff = [tr T_μν]: a mode without mass or a combination of modes before it";
    definite(field, matrix, |_| limit(INDEPENDENCE, epsilon), reason, place)
}

fn definite<const R: usize>(
    field: &'static str,
    matrix: [[f64; R]; R],
    least: impl Fn(usize) -> f64,
    reason: &'static str,
    place: impl Fn(usize) -> InvariantIndex,
) -> Result<(), InvariantError> {
    match first_bad_pivot(matrix, &least) {
        Some((k, found)) => {
            let expected = InvariantExpectation::Pivot { above: least(k), reason };
            Err(InvariantError { field, index: place(k), found, expected })
        }
        None => Ok(()),
    }
}

fn not_negative<const R: usize>(field: &'static str, matrix: &impl Square<R>) -> Result<(), InvariantError> {
    for k in 0..R {
        let found = matrix.at(k, k);
        if found < 0.0 {
            let (index, expected) = (matrix.place(HERE, k, k), InvariantExpectation::NotNegative);
            return Err(InvariantError { field, index, found, expected });
        }
    }
    Ok(())
}

fn structured<S: Square<3>>(
    field: &'static str,
    index: InvariantIndex,
    matrix: &S,
    mirror: Mirror,
    size: f64,
) -> Result<(), InvariantError> {
    match mirror {
        Mirror::Dense => Ok(()),
        Mirror::Symmetric => mirrored(field, index, matrix, 1.0, size),
        Mirror::Antisymmetric => mirrored(field, index, matrix, -1.0, size),
    }
}

/// The lower triangle, which is not read, is `sign` times the upper one, for entries of at most `size`.
fn mirrored<const R: usize, S: Square<R>>(
    field: &'static str,
    index: InvariantIndex,
    matrix: &S,
    sign: f64,
    size: f64,
) -> Result<(), InvariantError> {
    let within = limit(AGREEMENT, S::EPSILON) * size;
    let reason = if sign > 0.0 { "symmetric" } else { "antisymmetric, as the layout declares" };
    for i in 0..R {
        for j in i..R {
            // On the diagonal, an antisymmetric matrix is zero.
            let value = if i == j && sign < 0.0 { 0.0 } else { sign * matrix.at(i, j) };
            agree(field, matrix.place(index, j, i), matrix.at(j, i), value, within, reason)?;
        }
    }
    Ok(())
}

fn agree(
    field: &'static str,
    index: InvariantIndex,
    found: f64,
    value: f64,
    within: f64,
    reason: &'static str,
) -> Result<(), InvariantError> {
    if (found - value).abs() <= within {
        return Ok(());
    }
    let expected = InvariantExpectation::Value { value, within, reason };
    Err(InvariantError { field, index, found, expected })
}

fn largest<const R: usize>(matrix: &impl Square<R>) -> f64 {
    let mut largest = 0.0_f64;
    for i in 0..R {
        for j in 0..R {
            largest = largest.max(matrix.at(i, j).abs());
        }
    }
    largest
}

fn square<const R: usize>(entry: impl Fn(usize, usize) -> f64) -> [[f64; R]; R] {
    core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
}
