//! The scenes of `models/scenes` and the page about them.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::{Path, PathBuf};

use ffrf_host::scene::Scene;
use ffrf_host::simulate::check;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn every_scene_is_composed_assembled_and_commented() {
    let mut count = 0;
    for entry in std::fs::read_dir(root().join("models/scenes")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        count += 1;
        let shown = path.display();
        let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{shown}: {error}"));
        let found = check(&scene).unwrap_or_else(|error| panic!("{shown}: {error}"));
        assert!(found.assembled[0] < 1e-8, "{shown}: {:?}", found.assembled);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.starts_with('#') && text.contains("# ffrf simulate"), "{shown}: says how it is run");
    }
    assert!(count >= 6, "{count} scenes");
}

/// Keys are the fields of the tables that the reader knows: none can be added without a word about it.
#[test]
fn every_key_of_a_scene_file_is_on_its_page() {
    let page = std::fs::read_to_string(root().join("docs/scenes.md")).unwrap();
    let source = std::fs::read_to_string(root().join("ffrf-host/src/scene/file.rs")).unwrap();
    let tables = source.split("pub struct ").skip(1).filter(|table| {
        ["SimulationTable", "BodyTable", "JointTable", "DriveTable", "ForceTable", "SensorTable"]
            .iter()
            .any(|name| table.starts_with(name))
    });
    let mut keys = 0;
    for table in tables {
        let fields = table.lines().skip(1).take_while(|line| !line.starts_with('}'));
        for field in fields.filter_map(|line| line.trim().strip_prefix("pub ")?.split(':').next()) {
            keys += 1;
            let said =
                [format!("`{field}`"), format!("`{field} ="), format!("`{field}."), format!("{{ {field} =")];
            assert!(
                said.iter().any(|said| page.contains(said)),
                "docs/scenes.md does not say what `{field}` is"
            );
        }
    }
    assert!(keys > 40, "{keys} keys");
}
