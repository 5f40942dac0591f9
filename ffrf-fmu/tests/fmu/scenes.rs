//! Scenes of these tests, and instances of them.

use std::path::PathBuf;

use ffrf_fmu::{Instance, Model, Role};
use tempfile::TempDir;

/// A scene of `models/scenes`.
pub fn known(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(name)
}

/// The resources of the FMU of a scene, unpacked.
pub struct Unpacked {
    pub folder: TempDir,
    pub model: Model,
}

impl Unpacked {
    pub fn of(path: &std::path::Path) -> Self {
        let model = Model::of_scene(path).unwrap();
        let folder = tempfile::tempdir().unwrap();
        for (name, bytes) in &model.files {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, bytes).unwrap();
        }
        Self { folder, model }
    }

    /// The scene of a text; files that it names are looked for beside the scenes of `models/scenes`.
    pub fn of_text(text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.toml");
        let beside = known("").display().to_string();
        std::fs::write(&path, text.replace("\"../", &format!("\"{beside}/../"))).unwrap();
        Self::of(&path)
    }

    pub fn instance(&self) -> Instance {
        Instance::new(Model::in_resources(self.folder.path()).unwrap())
    }

    /// An instance in step mode.
    pub fn begun(&self) -> Instance {
        let mut instance = self.instance();
        instance.enter_initialisation(0.0).unwrap();
        instance.exit_initialisation().unwrap();
        instance
    }

    pub fn reference(&self, name: &str) -> u32 {
        let place = self.model.variables.iter().position(|variable| variable.name == name);
        u32::try_from(place.unwrap_or_else(|| panic!("no variable {name}"))).unwrap()
    }

    /// Value references of all columns of the samples.
    pub fn columns(&self) -> Vec<u32> {
        let variables = self.model.variables.iter().enumerate();
        let columns =
            variables.filter(|(_, variable)| matches!(variable.role, Role::Output(_) | Role::Local(_)));
        columns.map(|(reference, _)| u32::try_from(reference).unwrap()).collect()
    }

    /// All columns as bits.
    pub fn bits(&self, instance: &mut Instance) -> Vec<u64> {
        self.columns().into_iter().map(|reference| instance.get(reference).unwrap().to_bits()).collect()
    }
}

/// A free rotor with a motor about z, whose own input is a moment of 2 N m.
pub const ROTOR: &str = "
[simulation]
duration = 1.0
step = 1e-2

[bodies.rotor]
mass = 8.0
inertia = [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.1]]

[joints.shaft]
kind = \"revolute\"
first = \"ground\"
second = \"rotor\"

[forces.motor]
kind = \"actuator\"
joint = \"shaft\"
input = [2.0]

[sensors.turn]
kind = \"angle\"
of = \"shaft\"

[sensors.load]
kind = \"reaction_moment\"
of = \"shaft\"
";
