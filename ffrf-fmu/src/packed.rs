//! The files that a scene names: where they lie in the resources of an FMU.

use std::path::{Component, Path};

use ffrf_host::scene::file::{FunctionValue, SceneFile};

/// Where the file that a scene names lies, relative to the scene in the resources, with `/` between names.
///
/// What lies beside or below the scene keeps its path; a step up becomes a folder `up`, the root of a file system `root`.
pub fn packed_path(named: &str) -> String {
    let parts = Path::new(named).components().filter_map(|component| match component {
        Component::CurDir => None,
        Component::ParentDir => Some("up".into()),
        Component::RootDir | Component::Prefix(_) => Some("root".into()),
        Component::Normal(name) => Some(name.to_string_lossy()),
    });
    parts.collect::<Vec<_>>().join("/")
}

/// The files that the numbers of a scene depend on, as the scene names them, each once; `folder` is that of the scene.
pub fn sources(file: &SceneFile, folder: &Path) -> Vec<String> {
    let mut file = file.clone();
    let mut named = Vec::new();
    each(&mut file, |text, is_model| {
        if (is_model || is_file(folder, text)) && !named.contains(text) {
            named.push(text.clone());
        }
    });
    named
}

/// Lets a scene name its files as they lie in the resources, in `folder`.
pub(crate) fn redirect(file: &mut SceneFile, folder: &Path) {
    each(file, |text, is_model| {
        let packed = packed_path(text);
        if is_model || is_file(folder, &packed) {
            *text = packed;
        }
    });
}

fn is_file(folder: &Path, text: &str) -> bool {
    [".csv", ".txt", ".dat"].iter().any(|ending| text.ends_with(ending)) || folder.join(text).is_file()
}

/// Visits every text that names a file (true) or may name one (false). Surfaces are for pictures: no FMU has them.
fn each(file: &mut SceneFile, mut visit: impl FnMut(&mut String, bool)) {
    for (_, body) in &mut file.bodies {
        body.surface = None;
        if let Some(model) = &mut body.model {
            visit(model, true);
        }
    }
    let drives = file.joints.iter_mut().filter_map(|(_, joint)| joint.drive.as_mut());
    let drives = drives.flat_map(|drive| [&mut drive.angle, &mut drive.position]);
    let inputs = file.forces.iter_mut().map(|(_, force)| &mut force.input);
    for function in drives.chain(inputs) {
        if let Some(FunctionValue::Text(text)) = function {
            visit(text, false);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_inside_the_resources() {
        for (named, packed) in [
            ("rod.ffrf.json", "rod.ffrf.json"),
            ("./parts/rod.ffrf.json", "parts/rod.ffrf.json"),
            ("../conrod.ffrf.json", "up/conrod.ffrf.json"),
            ("parts/../rod.ffrf.json", "parts/up/rod.ffrf.json"),
            ("/models/rod.ffrf.json", "root/models/rod.ffrf.json"),
        ] {
            assert_eq!(packed_path(named), packed);
        }
    }
}
