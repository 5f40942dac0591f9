//! How a scene is simulated.

use ffrf_runtime::GeneralisedAlpha;
use ffrf_runtime::mechanism::Treatment;

use super::SceneError;
use super::file::SimulationTable;

/// A time integrator by its name in scene files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Integrator {
    /// Symplectic Euler, order 1.
    SymplecticEuler,
    /// Classical Runge-Kutta, order 4.
    Rk4,
    /// Dormand-Prince 5(4), fixed or error-controlled step.
    Dopri5,
    /// ROS2 with the modes implicit, order 2.
    LinearlyImplicit,
    /// Linearly implicit Euler, order 1.
    LinearlyImplicitEuler,
    /// Generalised-α, order 2.
    GeneralizedAlpha,
    /// Energy-momentum, order 2.
    EnergyMomentum,
    /// Exponential, order 2, of modes that no joint holds.
    Exponential,
    /// Radau IIA with three stages, order 5.
    Radau5,
    /// Radau IIA with four stages, order 7.
    Radau7,
}

impl Integrator {
    /// All with their names.
    pub const ALL: [(&'static str, Self); 10] = [
        ("symplectic_euler", Self::SymplecticEuler),
        ("rk4", Self::Rk4),
        ("dopri5", Self::Dopri5),
        ("linearly_implicit", Self::LinearlyImplicit),
        ("linearly_implicit_euler", Self::LinearlyImplicitEuler),
        ("generalized_alpha", Self::GeneralizedAlpha),
        ("energy_momentum", Self::EnergyMomentum),
        ("exponential", Self::Exponential),
        ("radau5", Self::Radau5),
        ("radau7", Self::Radau7),
    ];

    /// Its name in scene files.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name)
    }

    /// Whether the highest mode limits its step.
    pub fn is_explicit(self) -> bool {
        matches!(self, Self::SymplecticEuler | Self::Rk4 | Self::Dopri5)
    }

    /// Whether it solves linearly implicit stages.
    pub fn has_implicit_stages(self) -> bool {
        matches!(
            self,
            Self::LinearlyImplicit
                | Self::LinearlyImplicitEuler
                | Self::GeneralizedAlpha
                | Self::Radau5
                | Self::Radau7
        )
    }

    /// The treatments of constraints that it goes with; the first is the default.
    pub fn treatments(self) -> &'static [&'static str] {
        match self {
            Self::SymplecticEuler | Self::Rk4 | Self::Dopri5 => &["projection", "baumgarte", "minimal"],
            Self::LinearlyImplicit | Self::LinearlyImplicitEuler | Self::Radau5 | Self::Radau7 => {
                &["projection", "baumgarte"]
            }
            Self::GeneralizedAlpha => &["ggl", "index3", "projection", "baumgarte"],
            Self::EnergyMomentum => &["index3"],
            Self::Exponential => &["projection"],
        }
    }
}

/// Step size, or what chooses it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepChoice {
    /// Fixed, at most this. Units: s.
    Fixed(f64),
    /// By the relative tolerance.
    Tolerance(f64),
}

/// What the state of a mechanism is while it is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinates {
    /// The motion of every body in space.
    Absolute,
    /// What the joints of a tree leave free.
    Joint,
}

/// How a scene is simulated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Simulated time. Units: s.
    pub duration: f64,
    /// Step size.
    pub step: StepChoice,
    /// Integrator.
    pub integrator: Integrator,
    /// ρ∞ of the generalised-α method.
    pub spectral_radius: f64,
    /// Coordinates that are integrated.
    pub coordinates: Coordinates,
    /// Treatment of the constraints.
    pub treatment: Treatment<f64>,
    /// Time between samples. Units: s.
    pub output_step: f64,
}

/// Every treatment of constraints by its name in scene files.
const TREATMENTS: [&str; 5] = ["projection", "baumgarte", "ggl", "index3", "minimal"];

impl Settings {
    pub(crate) fn new(table: &SimulationTable) -> Result<Self, SceneError> {
        let positive = |what: &str, value: f64| {
            if value > 0.0 && value.is_finite() {
                Ok(value)
            } else {
                Err(SceneError::value(format!("simulation.{what}"), "a positive number", value))
            }
        };
        let duration = positive("duration", table.duration)?;
        let step = match (table.step, table.tolerance) {
            (Some(step), None) => StepChoice::Fixed(positive("step", step)?),
            (None, Some(tolerance)) => StepChoice::Tolerance(positive("tolerance", tolerance)?),
            (Some(_), Some(_)) => {
                return Err(SceneError::value("simulation", "either `step` or `tolerance`", "both"));
            }
            (None, None) => return Err(SceneError::value("simulation", "`step` or `tolerance`", "neither")),
        };
        let integrator = match (&table.integrator, step) {
            (None, StepChoice::Fixed(_)) => Integrator::Rk4,
            (None, StepChoice::Tolerance(_)) => Integrator::Dopri5,
            (Some(name), _) => {
                let found = Integrator::ALL.iter().find(|(known, _)| known == name);
                found.map(|(_, integrator)| *integrator).ok_or_else(|| SceneError::Unknown {
                    key: "simulation.integrator".to_owned(),
                    kind: "integrator",
                    found: name.escape_debug().to_string(),
                    known: Integrator::ALL.map(|(name, _)| name).join(", "),
                })?
            }
        };
        if matches!(step, StepChoice::Tolerance(_)) && integrator != Integrator::Dopri5 {
            return Err(SceneError::value(
                "simulation.tolerance",
                "`step` with a fixed-step integrator, or `dopri5`",
                table.integrator.as_deref().unwrap_or(""),
            ));
        }
        let output_step = match (table.output_step, step) {
            (Some(output), _) => positive("output_step", output)?.min(duration),
            (None, StepChoice::Fixed(step)) => step.min(duration),
            (None, StepChoice::Tolerance(_)) => duration / 100.0,
        };
        let spectral_radius = spectral_radius(table, integrator)?;
        // Baumgarte's gains follow the step, or the interval between samples where the step is free
        let scale = match step {
            StepChoice::Fixed(step) => step,
            StepChoice::Tolerance(_) => output_step,
        };
        let (treatment, coordinates) = treatment(table, integrator, scale)?;
        if table.gravity.iter().any(|g| !g.is_finite()) {
            return Err(SceneError::value(
                "simulation.gravity",
                "finite numbers",
                format!("{:?}", table.gravity),
            ));
        }
        Ok(Self { duration, step, integrator, spectral_radius, coordinates, treatment, output_step })
    }
}

/// ρ∞, of the generalised-α method alone.
fn spectral_radius(table: &SimulationTable, integrator: Integrator) -> Result<f64, SceneError> {
    let key = "simulation.rho_infinity";
    match table.rho_infinity {
        None => Ok(GeneralisedAlpha::<f64>::new().spectral_radius),
        Some(_) if integrator != Integrator::GeneralizedAlpha => Err(SceneError::value(
            key,
            "nothing: only `integrator = \"generalized_alpha\"` has it",
            format!("a value with `integrator = \"{}\"`", integrator.name()),
        )),
        Some(radius) if (0.0..=1.0).contains(&radius) => Ok(radius),
        Some(radius) => Err(SceneError::value(key, "a number from 0 to 1", radius)),
    }
}

/// The treatment of the constraints, if the integrator goes with it. `scale`: of Baumgarte's gains. Units: s.
fn treatment(
    table: &SimulationTable,
    integrator: Integrator,
    scale: f64,
) -> Result<(Treatment<f64>, Coordinates), SceneError> {
    let key = "simulation.constraints";
    let fitting = integrator.treatments();
    let name = table.constraints.as_deref().or(fitting.first().copied()).unwrap_or("");
    let treatment = match name {
        // nothing is left to project of joint coordinates
        "projection" | "minimal" => Treatment::projection(),
        // critically damped, within some ten steps
        "baumgarte" => Treatment::Baumgarte { alpha: 0.1 / scale, beta: 0.1 / scale },
        "ggl" => Treatment::StabilisedIndex2,
        "index3" => Treatment::Index3,
        other => {
            return Err(SceneError::Unknown {
                key: key.to_owned(),
                kind: "treatment of constraints",
                found: other.escape_debug().to_string(),
                known: TREATMENTS.join(", "),
            });
        }
    };
    if fitting.contains(&name) {
        let coordinates = if name == "minimal" { Coordinates::Joint } else { Coordinates::Absolute };
        return Ok((treatment, coordinates));
    }
    Err(SceneError::value(
        key,
        format!("{} with `integrator = \"{}\"`", fitting.join(" or "), integrator.name()),
        format!("`{name}`"),
    ))
}
