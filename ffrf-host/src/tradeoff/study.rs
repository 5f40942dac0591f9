//! A scene as its file has it, and the same scene with other modes and fidelities.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ffrf_codegen::{DEFAULT_LAYOUT_TOLERANCE, Fidelity};
use ffrf_model::ReducedBody;
use ffrf_runtime::State;

use super::TradeoffError;
use super::channel::{Channel, Quantity};
use super::configuration::Configuration;
use super::cost::StaticCost;
use super::held::{Held, with_fidelities};
use super::modes::Modes;
use super::scene_modes::{ModeValues, SceneModes, check_names, combinations};
use crate::scene::file::{BodyTable, FidelityValue, FunctionValue, SceneFile};
use crate::scene::{
    BodyCall, Coordinates, Integrator, MacroCalls, ModesValue, Scene, SceneError, Settings, StepChoice,
    macro_calls,
};
use crate::{HostBody, HostModal};

/// A scene to be studied.
pub struct Study {
    file: SceneFile,
    folder: PathBuf,
    /// For each body its modes; none of rigid ones.
    available: Vec<Option<usize>>,
    held: Held,
    own: Settings,
    /// Intervals between the times at which errors are taken.
    intervals: usize,
}

/// The scene with such modes and terms.
pub struct Variant {
    /// The scene.
    pub scene: Scene,
    /// Its state at time zero, with the joints met.
    pub initial: Vec<State<HostModal>>,
    /// What a step costs, as far as the generator knows.
    pub cost: StaticCost,
}

/// Most times at which errors are taken: enough to see every extremum of a few dozen oscillations.
const MOST_INTERVALS: f64 = 200.0;

/// What a number of steps may miss a whole number by, for round-off.
const WHOLE: f64 = 1e-6;

impl Study {
    /// Reads a scene and the models that it names. Errors: see [`SceneError`].
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let folder = path.parent().unwrap_or_else(|| Path::new("")).to_owned();
        Self::new(SceneFile::read(path)?, folder)
    }

    /// The study of a scene whose files are looked for in `folder`.
    pub fn new(file: SceneFile, folder: PathBuf) -> Result<Self, SceneError> {
        let file = with_fidelities(&file, &folder);
        // the scene itself must be sound, not only what becomes of it
        let scene = Scene::compose(&file, &folder)?;
        let own = scene.settings;
        let whole = Scene::compose(&with_bodies(&file, |_, _, table| without_modes(table)), &folder)?;
        let flexible = file.bodies.iter().map(|(_, table)| table.model.is_some());
        let counts = whole.mechanism.bodies().iter().map(HostBody::mode_count);
        let available = flexible.zip(counts).map(|(flexible, count)| flexible.then_some(count)).collect();
        let intervals = (own.duration / own.output_step).round().clamp(1.0, MOST_INTERVALS) as usize;
        Ok(Self { file, folder, available, held: Held::by(&whole), own, intervals })
    }

    /// The files that the scene names: models and tables of functions.
    pub fn inputs(&self) -> Vec<PathBuf> {
        let models = self.file.bodies.iter().filter_map(|(_, table)| table.model.as_ref());
        let drives = self.file.joints.iter().filter_map(|(_, table)| table.drive.as_ref());
        let drives = drives.flat_map(|drive| [&drive.angle, &drive.position]);
        let inputs = self.file.forces.iter().map(|(_, table)| &table.input);
        let tables = drives.chain(inputs).flatten().filter_map(|function| match function {
            FunctionValue::Text(text) => Some(text),
            FunctionValue::Polynomial(_) => None,
        });
        models.chain(tables).map(|name| self.folder.join(name)).filter(|path| path.is_file()).collect()
    }

    /// The same scene with these models in the place of those of flexible bodies: what errors are taken against, with modes that no
    /// configuration has, all of the finite-element model say. They have every mode, whatever the scene chooses.
    ///
    /// Errors: a body that is not there, is rigid, or begins deformed, which modal coordinates of other modes cannot say; a model
    /// that cannot be read, or does not have what the scene names.
    pub fn with_models(&self, models: &BTreeMap<String, PathBuf>) -> Result<Self, SceneError> {
        let mut file = self.file.clone();
        for (name, model) in models {
            let refused = |message: &str| SceneError::Key {
                key: format!("bodies.{name}"),
                message: message.to_owned(),
            };
            let table = file.bodies.iter_mut().find(|(body, _)| body == name);
            let Some((_, table)) = table.filter(|(_, table)| table.model.is_some()) else {
                return Err(refused(
                    "a reference has another model of it, but the scene has no such flexible body",
                ));
            };
            let begins = [&table.modal_coordinates, &table.modal_rates];
            if begins.into_iter().flatten().flatten().any(|number| *number != 0.0) {
                return Err(refused("a reference has other modes, but the body begins deformed in its own"));
            }
            without_modes(table);
            (table.model, table.fidelity) = (Some(model.display().to_string()), None);
        }
        Self::new(file, self.folder.clone())
    }

    /// The channels that quantities name. Errors: a quantity that the scene does not have.
    pub fn channels(&self, quantities: &[Quantity]) -> Result<Vec<Channel>, TradeoffError> {
        let variant = self.variant(&self.all_modes(), &self.richest())?;
        Channel::of(&variant.scene, quantities)
    }

    /// The most modes that a body of the scene has.
    pub fn most_modes(&self) -> usize {
        self.available.iter().flatten().copied().max().unwrap_or(0)
    }

    /// All that they have.
    pub fn all_modes(&self) -> SceneModes {
        SceneModes::first(self.most_modes())
    }

    /// Names of the flexible bodies, and how many modes they have.
    pub fn flexible_bodies(&self) -> Vec<(&str, usize)> {
        let bodies = self.file.bodies.iter().zip(&self.available);
        bodies.filter_map(|((name, _), available)| Some((name.as_str(), (*available)?))).collect()
    }

    /// The axis of modes that values make, which name a body each or none.
    ///
    /// Errors: a name that no flexible body has; the message lists those that there are.
    pub fn mode_axis(&self, values: &[ModeValues]) -> Result<Vec<SceneModes>, TradeoffError> {
        combinations(values, &self.flexible_bodies()).map_err(TradeoffError::Modes)
    }

    /// The one form that a choice of modes of these bodies has. Errors: a name that no flexible body has.
    pub fn canonical(&self, modes: SceneModes) -> Result<SceneModes, TradeoffError> {
        self.check_bodies(&modes)?;
        Ok(modes.canonical(&self.flexible_bodies()))
    }

    /// Errors: a name that no flexible body has.
    fn check_bodies(&self, modes: &SceneModes) -> Result<(), TradeoffError> {
        let SceneModes::Each(each) = modes else { return Ok(()) };
        check_names(each.keys().map(String::as_str), &self.flexible_bodies()).map_err(TradeoffError::Modes)
    }

    /// Every term of the kinetic energy that all flexible bodies hold: what the reference has. `full`, but of bodies that were
    /// read from integrals and lack some of second order.
    pub fn richest(&self) -> Fidelity {
        self.held.richest()
    }

    /// The levels of terms that all flexible bodies have, from the cheapest to [`richest`](Self::richest): `constant`, `linear`,
    /// `unstiffened` where a body has geometric stiffness, `full`, as far as they hold what these keep.
    pub fn levels(&self) -> Vec<Fidelity> {
        self.held.levels()
    }

    /// Errors: a flexible body lacks a term of one of the fidelities.
    pub fn check_held(&self, fidelities: &[Fidelity]) -> Result<(), SceneError> {
        fidelities.iter().try_for_each(|fidelity| self.held.check(fidelity))
    }

    /// What the bodies hold of second order.
    pub(super) fn held(&self) -> &Held {
        &self.held
    }

    /// How the scene's file says that it is simulated.
    pub fn settings(&self) -> &Settings {
        &self.own
    }

    /// The times at which errors are taken: even, from zero to the duration.
    pub fn times(&self) -> Vec<f64> {
        let (count, duration) = (self.intervals, self.own.duration);
        (0..=count).map(|k| if k == count { duration } else { duration * k as f64 / count as f64 }).collect()
    }

    /// The interval between these times: no step is longer. Units: s.
    pub fn interval(&self) -> f64 {
        self.own.duration / self.intervals as f64
    }

    /// The same study with its samples at whole multiples of `step` (s), no more and no closer together than they were, until
    /// the last whole step of the scene; none if there is no whole one. No sample cuts such a step short.
    pub fn in_steps_of(&self, step: f64) -> Option<Self> {
        let whole = (self.own.duration / step + WHOLE).floor();
        if whole < 1.0 || !whole.is_finite() {
            return None;
        }
        let each = (whole / self.intervals as f64 - WHOLE).ceil().max(1.0);
        let intervals = (whole / each).floor();
        let (duration, output_step) = (intervals * each * step, each * step);
        let mut file = self.file.clone();
        (file.simulation.duration, file.simulation.output_step) = (duration, Some(output_step));
        Some(Self {
            file,
            folder: self.folder.clone(),
            available: self.available.clone(),
            held: self.held.clone(),
            own: Settings { duration, output_step, ..self.own },
            intervals: intervals as usize,
        })
    }

    /// The settings of a run: the constraints as the scene has them where the integrator goes with that.
    ///
    /// Joint coordinates are left for absolute ones, which every integrator and number type goes with.
    pub fn settings_of(&self, integrator: Integrator, step: StepChoice) -> Result<Settings, SceneError> {
        let mut table = self.file.simulation.clone();
        table.integrator = Some(integrator.name().to_owned());
        (table.step, table.tolerance) = match step {
            StepChoice::Fixed(step) => (Some(step), None),
            StepChoice::Tolerance(tolerance) => (None, Some(tolerance)),
        };
        table.output_step = Some(self.own.output_step);
        if integrator != Integrator::GeneralizedAlpha {
            table.rho_infinity = None;
        }
        let goes = |name: &String| name != "minimal" && integrator.treatments().contains(&name.as_str());
        table.constraints = table.constraints.filter(goes);
        let settings = Settings::new(&table)?;
        Ok(Settings { coordinates: Coordinates::Absolute, ..settings })
    }

    /// The macro calls that make the scene with a configuration. `title`: name of the mechanism.
    pub fn macro_calls(&self, title: &str, configuration: &Configuration) -> String {
        let bodies = self.file.bodies.iter().zip(&self.available);
        let calls: Vec<Option<BodyCall>> = bodies
            .map(|((name, _), available)| {
                let modes = available.map(|most| configuration.modes.of(name, most))?;
                let (mode_count, fidelity) = (modes.count(), configuration.fidelity.clone());
                Some(BodyCall { modes: modes.selection(), mode_count, fidelity })
            })
            .collect();
        let scalar = configuration.scalar;
        let calls = MacroCalls {
            title,
            bodies: &calls,
            scalar,
            layout_tolerance: DEFAULT_LAYOUT_TOLERANCE,
            accelerations: None,
            implicit_accelerations: None,
            projection: None,
            implicit_projection: None,
        };
        let text = macro_calls(&self.file, &self.folder, &calls);
        let (name, step) = (configuration.integrator.name(), configuration.step);
        format!("{text}// integrator: {name}, steps of {step:e} s\n")
    }

    /// The model of body `index` with all its modes. Errors: the body is rigid, or its model cannot be read.
    pub(super) fn model(&self, index: usize) -> Result<ReducedBody, TradeoffError> {
        let body = self.file.bodies.get(index);
        let named = body.and_then(|(name, table)| table.model.as_ref().map(|model| (name, model)));
        let Some((name, model)) = named else {
            return Err(TradeoffError::Rigid { index });
        };
        let path = self.folder.join(model);
        let read = ReducedBody::read(&path);
        let key = format!("bodies.{name}.model");
        Ok(read.map_err(|source| SceneError::Model { key, path, source: Box::new(source) })?)
    }

    /// The flexible body `index` with all its modes and other terms. Errors: its model cannot be read.
    pub(super) fn body_with(&self, index: usize, fidelity: &Fidelity) -> Result<HostBody, TradeoffError> {
        // another body may not hold these terms
        let others = self.richest();
        let variant = with_bodies(&self.file, |body, _, table| {
            if let Some(available) = self.available.get(body).copied().flatten() {
                let fidelity = if body == index { fidelity } else { &others };
                with_modes(table, available, &Modes::first(available), fidelity);
            }
        });
        let scene = Scene::compose(&variant, &self.folder)?;
        Ok(scene.mechanism.bodies()[index].clone())
    }

    /// The scene's file with these modes of each flexible body, and these terms; its files are looked for in
    /// [`folder`](Self::folder).
    pub fn file_with(&self, modes: &SceneModes, fidelity: &Fidelity) -> SceneFile {
        with_bodies(&self.file, |body, name, table| {
            if let Some(available) = self.available.get(body).copied().flatten() {
                with_modes(table, available, &modes.of(name, available), fidelity);
            }
        })
    }

    /// Where the files that the scene names are looked for.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The scene with these modes of each flexible body, and these terms. Errors: the scene cannot be assembled so, or a body
    /// that is named is none that is flexible.
    pub fn variant(&self, modes: &SceneModes, fidelity: &Fidelity) -> Result<Variant, TradeoffError> {
        self.check_bodies(modes)?;
        let file = self.file_with(modes, fidelity);
        let scene = Scene::compose(&file, &self.folder)?;
        let (initial, _) = scene.assembled()?;
        let cost = StaticCost::of(&file, &self.folder, &scene)?;
        Ok(Variant { scene, initial, cost })
    }
}

/// A copy of a scene with other bodies; joint coordinates, which not every integrator goes with, are left.
fn with_bodies(file: &SceneFile, change: impl Fn(usize, &str, &mut BodyTable)) -> SceneFile {
    let mut copy = file.clone();
    copy.simulation.constraints = copy.simulation.constraints.filter(|name| name != "minimal");
    for (index, (name, table)) in copy.bodies.iter_mut().enumerate() {
        change(index, name, table);
    }
    copy
}

fn without_modes(table: &mut BodyTable) {
    (table.modes, table.modal_coordinates, table.modal_rates) = (None, None, None);
}

/// Initial values of modes that the file does not use are zero. `available`: modes of the body's model.
fn with_modes(table: &mut BodyTable, available: usize, modes: &Modes, fidelity: &Fidelity) {
    // what was composed before has modes that exist
    let own = table.modes.as_ref().and_then(|own| own.0.indices(available).ok());
    let own = own.unwrap_or_else(|| (0..available).collect());
    for list in [&mut table.modal_coordinates, &mut table.modal_rates].into_iter().flatten() {
        let value = |mode: usize| {
            let place = own.iter().position(|own| *own == mode);
            place.and_then(|place| list.get(place).copied()).unwrap_or(0.0)
        };
        *list = modes.indices().into_iter().map(value).collect();
    }
    table.modes = Some(ModesValue(modes.selection()));
    table.fidelity = Some(match fidelity {
        Fidelity::Terms(terms) => {
            FidelityValue::Terms(terms.iter().map(|term| term.name().to_owned()).collect())
        }
        level => FidelityValue::Level(level.name().to_owned()),
    });
}
