//! The rows that `--check` names as redundant: as many as geometry says, of joints that stand in the loop.

use std::path::Path;

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::simulate::{SceneCheck, check};

fn scenes() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes")
}

fn checked(text: &str) -> SceneCheck {
    let file = SceneFile::parse(text).unwrap_or_else(|error| panic!("{error}"));
    let scene = Scene::compose(&file, &scenes()).unwrap_or_else(|error| panic!("{error}"));
    check(&scene).unwrap_or_else(|error| panic!("{error}"))
}

fn scene(name: &str) -> String {
    std::fs::read_to_string(scenes().join(name)).unwrap()
}

/// Velocities, rows, redundant rows and degrees of freedom.
#[track_caller]
fn counts(found: &SceneCheck, expected: [usize; 4]) {
    let numbers = [found.velocities, found.rows, found.redundant.len(), found.degrees_of_freedom];
    assert_eq!(numbers, expected, "{:?}", found.redundant);
}

#[test]
fn the_four_bar_names_three_rows_for_each_loop() {
    // five bodies, seven revolutes, two planar loops
    let found = checked(&scene("four_bar.toml"));
    counts(&found, [30, 35, 6, 1]);
    // out of the plane: nothing that holds x or y in it; and only joints that close a loop
    for row in &found.redundant {
        let (joint, what) = row.split_once(": ").unwrap();
        assert!(["translation z", "rotation x", "rotation y"].contains(&what), "{row}");
        assert!(["a2", "b0", "b1", "b1_middle", "b2", "a1"].contains(&joint), "{row}");
    }
}

#[test]
fn bricards_mechanism_names_one_row() {
    let found = checked(&scene("bricard.toml"));
    counts(&found, [30, 30, 1, 1]);
    // the last joint of the file closes the chain
    assert!(found.redundant[0].starts_with("hinge_6: "), "{:?}", found.redundant);
}

#[test]
fn a_joint_declared_twice_names_all_rows_of_the_second() {
    let text = scene("double_pendulum.toml");
    let once = checked(&text);
    counts(&once, [12, 10, 0, 2]);
    let twice = format!(
        "{text}\n[joints.elbow_again]\nkind = \"revolute\"\nfirst = \"upper.END\"\nsecond = \"lower\"\n"
    );
    let found = checked(&twice);
    counts(&found, [12, 15, 5, 2]);
    let names = ["translation x", "translation y", "translation z", "rotation x", "rotation y"];
    assert_eq!(found.redundant, names.map(|name| format!("elbow_again: {name}")));
}

#[test]
fn the_other_scenes_count_as_they_say() {
    counts(&checked(&scene("andrews_squeezer.toml")), [42, 50, 9, 1]);
    // two springs as struts: nothing is redundant, shaft, rods and slider move
    counts(&checked(&scene("governor.toml")), [24, 20, 0, 4]);
    // four modes on a driven hub
    counts(&checked(&scene("spin_up_beam.toml")), [10, 6, 0, 4]);
}
