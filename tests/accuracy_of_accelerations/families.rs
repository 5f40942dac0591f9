//! Families of bodies, each hard in its own way, with the condition number as far as it can be prescribed.

use ffrf::nalgebra::{DMatrix, Rotation3, Vector3};

use crate::fields::{Field, Fields};
use ffrf_test_kit::random::Random;

/// Bodies of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// A block whose orthonormal modes are like nothing in particular.
    Random,
    /// A rod clamped at one end: orthonormal polynomials that vanish there. They nearly follow rigid motions.
    Clamped,
    /// The same polynomials as they are: a Vandermonde basis, Θ_ff dense and badly conditioned.
    ClampedPowers,
    /// A rod with six static modes of its tip and sines between its ends, not orthogonal.
    CraigBampton,
    /// A rod thin by √κ, its axis along x.
    Slender,
    /// The same in a frame askew to it.
    Askew,
    /// A body far from the origin of its frame, by √κ of its size.
    FarFrame,
    /// Modes that are pairs of nearly equal fields. Θ_ff dense.
    NearlyDependent,
    /// Combinations of orthonormal modes with a prescribed spectrum of Θ_ff, dense.
    Spectrum,
    /// Up to six modes that are nearly rigid motions; Θ_ff dense.
    NearlyRigid,
    /// The same, orthonormal: Θ_ff = I.
    NearlyRigidNormalised,
    /// One mode that is nearly a translation askew to the axes: Θ_ff = I, all of the loss in the constant block.
    NearlyTranslation,
    /// Nearly dependent and nearly rigid at once: half of the digits each.
    Both,
    /// Modes of sizes between √κ and 1 / √κ: a condition number that scaling takes away.
    Graded,
}

impl Family {
    pub const ALL: [Self; 14] = [
        Self::Random,
        Self::Clamped,
        Self::ClampedPowers,
        Self::CraigBampton,
        Self::Slender,
        Self::Askew,
        Self::FarFrame,
        Self::NearlyDependent,
        Self::Spectrum,
        Self::NearlyRigid,
        Self::NearlyRigidNormalised,
        Self::NearlyTranslation,
        Self::Both,
        Self::Graded,
    ];

    /// Whether the condition number can be chosen; otherwise the number of modes decides.
    pub fn has_condition(self) -> bool {
        !matches!(self, Self::Random | Self::Clamped | Self::ClampedPowers | Self::CraigBampton)
    }

    /// Whether there are such bodies with this many modes.
    pub fn admits(self, modes: usize) -> bool {
        match self {
            Self::NearlyRigid | Self::NearlyRigidNormalised | Self::NearlyTranslation => modes >= 1,
            Self::NearlyDependent | Self::Spectrum | Self::Both | Self::Graded => modes >= 2,
            // Higher powers depend on each other to all digits.
            Self::ClampedPowers => modes <= 16,
            Self::CraigBampton => modes >= 6,
            _ => true,
        }
    }

    /// How far the body is deformed, relative to its size: beyond this the condition is another one.
    pub fn deformation(self, condition: f64) -> f64 {
        match self {
            Self::Slender | Self::Askew | Self::NearlyRigid | Self::NearlyRigidNormalised | Self::Both => {
                condition.sqrt().recip()
            }
            _ => 0.05,
        }
    }

    /// How fast it spins. Far from the origin the centrifugal forces would be all that is seen.
    pub fn spin(self, condition: f64) -> f64 {
        if self == Self::FarFrame { condition.sqrt().recip() } else { 1.0 }
    }

    /// A body of this kind. The condition number is that of the scaled mass matrix, up to a factor of about ten.
    pub fn fields(self, seed: u64, modes: usize, condition: f64) -> Fields {
        let mut random = Random::new(seed);
        let small = condition.sqrt().recip();
        let nodes = 12 + 2 * modes;
        match self {
            Self::Random => orthonormal(Fields::nodes(&mut random, nodes, 0.5), &mut random, modes),
            Self::Clamped => {
                let mut rod = rod(&mut random, nodes, modes);
                rod.orthonormalise();
                rod
            }
            Self::ClampedPowers => rod(&mut random, nodes, modes),
            Self::CraigBampton => craig_bampton(&mut random, nodes, modes),
            Self::Slender => slender(&mut random, nodes, modes, small),
            Self::Askew => {
                let mut fields = slender(&mut random, nodes, modes, small);
                let turn = Rotation3::from_euler_angles(0.7, -0.5, 0.9);
                fields.map(|u| turn * u);
                fields
            }
            Self::FarFrame => {
                let mut fields = orthonormal(Fields::nodes(&mut random, nodes, 0.5), &mut random, modes);
                let distance = Vector3::new(0.6, -0.5, 0.62) * 0.15 / small;
                fields.positions.iter_mut().for_each(|x| *x += distance);
                fields
            }
            Self::NearlyDependent => {
                let mut fields = orthonormal(Fields::nodes(&mut random, nodes, 0.5), &mut random, modes);
                let weights = DMatrix::from_fn(modes, modes, |mu, nu| {
                    let is_second = mu % 2 == 1;
                    match mu {
                        _ if mu == nu => {
                            if is_second {
                                small
                            } else {
                                1.0
                            }
                        }
                        _ if is_second && nu + 1 == mu => 1.0,
                        _ => 0.0,
                    }
                });
                fields.combine(&weights);
                fields
            }
            Self::Spectrum => {
                let mut fields = orthonormal(Fields::nodes(&mut random, nodes, 0.5), &mut random, modes);
                fields.combine(&spectrum(&mut random, modes, small));
                fields
            }
            Self::NearlyRigid | Self::NearlyRigidNormalised => {
                let mut fields = nearly_rigid(&mut random, nodes, modes, 3.0 * small);
                if self == Self::NearlyRigidNormalised {
                    fields.orthonormalise();
                }
                fields
            }
            Self::NearlyTranslation => {
                let mut fields = orthonormal(Fields::nodes(&mut random, nodes, 0.5), &mut random, modes);
                let field = &fields.modes[0];
                let along = Vector3::new(0.48, -0.6, 0.64);
                let total: f64 = fields.masses.iter().sum();
                let first: Field = field.iter().map(|u| along / total.sqrt() + u * small).collect();
                fields.modes[0] = first;
                fields.orthonormalise();
                fields
            }
            Self::Both => {
                let mut fields = nearly_rigid(&mut random, nodes, modes, small.sqrt());
                fields.combine(&spectrum(&mut random, modes, small.sqrt()));
                fields
            }
            Self::Graded => {
                let mut fields = orthonormal(Fields::nodes(&mut random, nodes, 0.5), &mut random, modes);
                let mixing = DMatrix::from_fn(modes, modes, |mu, nu| {
                    let size = small.powf(2.0 * mu as f64 / (modes - 1) as f64 - 1.0);
                    size * if mu == nu { 1.0 } else { 0.3 / modes as f64 * random.number() }
                });
                fields.combine(&mixing);
                fields
            }
        }
    }
}

/// Random orthonormal modes, of the mass of the body.
fn orthonormal(mut fields: Fields, random: &mut Random, modes: usize) -> Fields {
    fields.modes = (0..modes).map(|_| fields.random_field(random)).collect();
    fields.orthonormalise();
    fields
}

fn slender(random: &mut Random, nodes: usize, modes: usize, thickness: f64) -> Fields {
    let fields = Fields::nodes(random, nodes, thickness);
    orthonormal(fields, random, modes)
}

/// A thick rod from x = 0 to x = 2 with bending, stretching and twisting modes that vanish at x = 0.
fn rod(random: &mut Random, nodes: usize, modes: usize) -> Fields {
    let mut fields = Fields::nodes(random, nodes, 0.1);
    fields.positions.iter_mut().for_each(|x| x.x += 1.0);
    fields.modes = (0..modes)
        .map(|mu| {
            let degree = (mu / 4) as i32;
            let field = fields.field(|x| {
                let (bend, slope) = ((0.5 * x.x).powi(degree + 2), (0.5 * x.x).powi(degree + 1));
                let slope = slope * 0.5 * f64::from(degree + 2);
                match mu % 4 {
                    0 => Vector3::new(-x.y * slope, bend, 0.0),
                    1 => Vector3::new(-x.z * slope, 0.0, bend),
                    2 => Vector3::new((0.5 * x.x).powi(degree + 1), 0.0, 0.0),
                    _ => Vector3::new(0.0, -x.z, x.y) * (0.5 * x.x).powi(degree + 1),
                }
            });
            fields.scaled(&field)
        })
        .collect();
    fields
}

/// Six static modes of the tip of a rod with a fixed root, and sines between both.
fn craig_bampton(random: &mut Random, nodes: usize, modes: usize) -> Fields {
    let mut fields = Fields::nodes(random, nodes, 0.1);
    fields.positions.iter_mut().for_each(|x| x.x += 1.0);
    fields.modes = (0..modes)
        .map(|mu| {
            let field = fields.field(|x| {
                let s = 0.5 * x.x;
                // Hermite polynomials of the tip: displacement and slope.
                let (shift, turn) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
                let (shift_slope, turn_slope) = (3.0 * s * (1.0 - s), 0.5 * s * (3.0 * s - 2.0));
                match mu {
                    0 => Vector3::new(s, 0.0, 0.0),
                    1 => Vector3::new(-x.y * shift_slope, shift, 0.0),
                    2 => Vector3::new(-x.z * shift_slope, 0.0, shift),
                    3 => Vector3::new(0.0, -x.z, x.y) * s,
                    4 => Vector3::new(-x.y * turn_slope, turn, 0.0),
                    5 => Vector3::new(-x.z * turn_slope, 0.0, turn),
                    _ => {
                        let wave = (std::f64::consts::PI * s * f64::from((mu as i32 - 6) / 3 + 1)).sin();
                        match mu % 3 {
                            0 => Vector3::new(0.0, wave, 0.0),
                            1 => Vector3::new(0.0, 0.0, wave),
                            _ => Vector3::new(wave, 0.0, 0.0),
                        }
                    }
                }
            });
            fields.scaled(&field)
        })
        .collect();
    fields
}

/// Random modes, the first of which are rigid motions up to `small` of themselves.
fn nearly_rigid(random: &mut Random, nodes: usize, modes: usize, small: f64) -> Fields {
    let mut fields = orthonormal(Fields::nodes(random, nodes, 0.5), random, modes);
    let count = if modes > 8 { 6 } else { modes.div_ceil(2) };
    for mu in 0..count {
        let (along, about) = (
            Vector3::new(random.number(), random.number(), random.number()),
            Vector3::new(random.number(), random.number(), random.number()),
        );
        let field = fields.scaled(&fields.field(|x| along + about.cross(x)));
        let rest = fields.scaled(&fields.modes[mu]);
        fields.modes[mu] = field.iter().zip(&rest).map(|(u, v)| u + v * small).collect();
    }
    fields
}

/// U Σ Vᵀ with Σ between 1 and `small`.
fn spectrum(random: &mut Random, modes: usize, small: f64) -> DMatrix<f64> {
    let mut orthogonal = || DMatrix::from_fn(modes, modes, |_, _| random.number()).qr().q();
    let (left, right) = (orthogonal(), orthogonal());
    let last = (modes - 1).max(1) as f64;
    let sizes = DMatrix::from_fn(modes, modes, |i, j| if i == j { small.powf(i as f64 / last) } else { 0.0 });
    left * sizes * right
}
