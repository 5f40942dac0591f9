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
}

impl Integrator {
    /// All with their names.
    pub const ALL: [(&'static str, Self); 7] = [
        ("symplectic_euler", Self::SymplecticEuler),
        ("rk4", Self::Rk4),
        ("dopri5", Self::Dopri5),
        ("linearly_implicit", Self::LinearlyImplicit),
        ("linearly_implicit_euler", Self::LinearlyImplicitEuler),
        ("generalized_alpha", Self::GeneralizedAlpha),
        ("energy_momentum", Self::EnergyMomentum),
    ];

    /// Its name in scene files.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name)
    }

    /// The treatments of constraints that it goes with; the first is the default.
    pub fn treatments(self) -> &'static [&'static str] {
        match self {
            Self::SymplecticEuler | Self::Rk4 | Self::Dopri5 => &["projection", "baumgarte"],
            Self::LinearlyImplicit | Self::LinearlyImplicitEuler => &["projection", "baumgarte"],
            Self::GeneralizedAlpha => &["ggl", "index3", "projection", "baumgarte"],
            Self::EnergyMomentum => &["index3"],
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
    /// Treatment of the constraints.
    pub treatment: Treatment<f64>,
    /// Time between samples. Units: s.
    pub output_step: f64,
}

/// Every treatment of constraints by its name in scene files.
const TREATMENTS: [&str; 4] = ["projection", "baumgarte", "ggl", "index3"];

/// Corrections of each level per step, and the residual (m or rad) that a step may be left with.
pub(super) const PROJECTION: Treatment<f64> = Treatment::Projection { iterations: 8, tolerance: 1e-6 };

impl Settings {
    pub(super) fn new(table: &SimulationTable) -> Result<Self, SceneError> {
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
        let treatment = treatment(table, integrator, scale)?;
        if table.gravity.iter().any(|g| !g.is_finite()) {
            return Err(SceneError::value(
                "simulation.gravity",
                "finite numbers",
                format!("{:?}", table.gravity),
            ));
        }
        Ok(Self { duration, step, integrator, spectral_radius, treatment, output_step })
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
) -> Result<Treatment<f64>, SceneError> {
    let key = "simulation.constraints";
    let fitting = integrator.treatments();
    let name = table.constraints.as_deref().or(fitting.first().copied()).unwrap_or("");
    let treatment = match name {
        "projection" => PROJECTION,
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
        return Ok(treatment);
    }
    Err(SceneError::value(
        key,
        format!("{} with `integrator = \"{}\"`", fitting.join(" or "), integrator.name()),
        format!("`{name}`"),
    ))
}
