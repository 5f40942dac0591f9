//! `ffrf view` and the pictures of `ffrf reduce`: what a browser gets.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::Path;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::Value;

use super::program::{changed, ffrf, succeed};

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// The document of a file in glTF's binary form.
fn document(glb: &[u8]) -> Value {
    assert_eq!(&glb[..4], b"glTF");
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&glb[20..20 + length]).unwrap()
}

/// The model that a page carries.
fn model_of(page: &str) -> Vec<u8> {
    let (_, rest) = page.split_once("<script id=\"model\" type=\"text/plain\">").unwrap();
    BASE64_STANDARD.decode(rest.split_once("</script>").unwrap().0).unwrap()
}

/// Reduces the connecting rod with every picture; the folder, and the model that `reduce` showed.
fn reduced(modes: &str) -> (tempfile::TempDir, Value) {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let deck = repository().join("models/conrod/conrod.inp").display().to_string();
    let (surface, page, sheet, body) = (at("c.npz"), at("c.html"), at("c.svg"), at("c.ffrf.json"));
    let pictures = ["--surface", &surface, "--view", &page, "--sheet", &sheet];
    let rest = ["--modes", modes, "--marker", "BIG_END=BIG_END", "--title", "Rod <1>", "-o", &body];
    succeed(&[&["reduce", "--calculix", &deck][..], &pictures, &rest].concat());
    let shown = document(&model_of(&std::fs::read_to_string(page).unwrap()));
    (folder, shown)
}

#[test]
fn a_part_is_shown_with_its_modes_and_markers() {
    let (folder, shown) = reduced("3");
    let at = |name: &str| folder.path().join(name).display().to_string();
    assert_eq!(shown["extras"]["title"], "Rod <1>");
    let names = shown["meshes"][0]["extras"]["targetNames"].as_array().unwrap();
    assert_eq!(names.len(), 3);
    assert!(names[0].as_str().unwrap().starts_with("mode 1: 1598."), "{names:?}");
    let marker = &shown["nodes"][0]["extras"]["markers"][0];
    assert_eq!(marker["name"], "BIG_END");
    // the marker and its modes are those of the reduced body
    let body: Value = serde_json::from_str(&std::fs::read_to_string(at("c.ffrf.json")).unwrap()).unwrap();
    assert_eq!(marker["position"], body["markers"][0]["position"]);
    assert_eq!(marker["modes"], body["markers"][0]["translation"]);
    assert!(shown.get("animations").is_none());

    // the same from the files, later
    succeed(&[
        "view",
        &at("c.ffrf.json"),
        "--surface",
        &at("c.npz"),
        "-o",
        &at("again.glb"),
        "--sheet",
        &at("again.svg"),
    ]);
    let again = document(&std::fs::read(at("again.glb")).unwrap());
    assert_eq!(again, shown);
    let sheets = ["c.svg", "again.svg"].map(|name| std::fs::read_to_string(at(name)).unwrap());
    assert_eq!(sheets[0], sheets[1]);
    assert_eq!(sheets[0].matches("<image").count(), 3);
    assert!(sheets[0].contains("Rod &lt;1&gt;") && sheets[0].contains("mode 3: "));
    // three different pictures of a part, none of them empty
    let mut pictures: Vec<&str> = sheets[0].split("base64,").skip(1).collect();
    assert!(pictures.iter().all(|picture| picture.len() > 5_000));
    pictures.sort_unstable();
    pictures.dedup();
    assert_eq!(pictures.len(), 3);
}

#[test]
fn interfaces_have_spokes_to_the_nodes_that_they_hold() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let deck = repository().join("models/conrod/conrod.inp").display().to_string();
    let (surface, page, body) = (at("c.npz"), at("c.html"), at("c.ffrf.json"));
    let interfaces = ["--interface", "BIG=set:BIG_END,rbe2", "--interface", "SMALL=set:SMALL_END,rbe3"];
    let rest =
        ["--marker", "MID=BIG_END", "--modes", "2", "--surface", &surface, "--view", &page, "-o", &body];
    succeed(&[&["reduce", "--calculix", &deck][..], &interfaces, &rest].concat());
    let shown = document(&model_of(&std::fs::read_to_string(page).unwrap()));
    let markers = shown["nodes"][0]["extras"]["markers"].as_array().unwrap();
    let model: Value = serde_json::from_str(&std::fs::read_to_string(&body).unwrap()).unwrap();
    let points = shown["accessors"][0]["count"].as_u64().unwrap();
    for (marker, known) in markers.iter().zip(model["markers"].as_array().unwrap()) {
        let nodes = known["nodes"].as_array().unwrap().len();
        match known["name"].as_str().unwrap() {
            "MID" => assert!(marker.get("held").is_none() && known.get("coupling").is_none()),
            name => {
                assert_eq!(known["coupling"], if name == "BIG" { "rigid" } else { "average" });
                // corner nodes alone are on the surface
                let held: Vec<u64> =
                    marker["held"].as_array().unwrap().iter().map(|point| point.as_u64().unwrap()).collect();
                assert!(held.len() > nodes / 8 && held.len() < nodes, "{} of {nodes}", held.len());
                assert!(held.iter().all(|point| *point < points));
            }
        }
    }
    let said = String::from_utf8(succeed(&["inspect", &body]).stdout).unwrap();
    for part in ["BIG (198 nodes, as one rigid body: RBE2)", "SMALL (132 nodes, their mean: RBE3)"] {
        assert!(said.contains(part), "{said}");
    }
}

#[test]
fn a_body_without_a_surface_is_bars_and_a_motion_is_a_page() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let body = repository().join("models/conrod.ffrf.json").display().to_string();
    succeed(&["view", &body, "-o", &at("bars.html")]);
    let shown = document(&model_of(&std::fs::read_to_string(at("bars.html")).unwrap()));
    let targets = shown["meshes"][0]["primitives"][0]["targets"].as_array().unwrap();
    assert_eq!(targets.len(), 8);

    let scene = changed(folder.path(), "flexible_pendulum.toml", &[("duration = 0.5", "duration = 0.02")]);
    succeed(&["simulate", &scene, "-o", &at("o.csv"), "--animation", &at("m.glb")]);
    succeed(&["simulate", &scene, "-o", &at("o.csv"), "--animation", &at("direct.html")]);
    succeed(&["view", &at("m.glb"), "-o", &at("later.html")]);
    let motion = std::fs::read(at("m.glb")).unwrap();
    for page in ["direct.html", "later.html"] {
        assert_eq!(model_of(&std::fs::read_to_string(at(page)).unwrap()), motion);
    }
    let shown = document(&motion);
    assert_eq!(shown["animations"].as_array().unwrap().len(), 1);
    assert_eq!(shown["nodes"][0]["extras"]["markers"][0]["name"], "BIG_END");
}

#[test]
fn what_cannot_be_shown_is_refused_and_nothing_is_written() {
    let (folder, _) = reduced("1");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let body = at("c.ffrf.json");
    std::fs::write(at("m.glb"), b"glTF and so on").unwrap();
    std::fs::write(at("torn.json"), b"{").unwrap();
    let eight = repository().join("models/conrod.ffrf.json").display().to_string();
    let before = std::fs::read_dir(folder.path()).unwrap().count();
    for (arguments, expected) in [
        (vec![&*body, "-o", &at("a.obj")], "expected a name that ends in .html or .glb"),
        (vec![&*body, "--sheet", &at("a.png")], "expected a name that ends in .svg"),
        (vec![&*body, "--sheet", &at("a.svg")], "--sheet needs the surface"),
        (
            vec![&*at("m.glb"), "--surface", &at("c.npz"), "-o", &at("a.html")],
            "--surface is for a reduced body",
        ),
        (
            vec![&*at("torn.json"), "-o", &at("a.html")],
            "expected a reduced body (.ffrf.json) or a motion (.glb)",
        ),
        (vec![&*eight, "--surface", &at("c.npz"), "-o", &at("a.html")], "expected 8 modes or more"),
        (vec![&*at("nowhere.json"), "-o", &at("a.html")], "nowhere.json"),
    ] {
        let run = ffrf(&[&["view"][..], &arguments].concat());
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(1), "{said}");
        assert!(said.contains(expected), "{said}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), before);
}
