//! What `ffrf simulate` writes besides text, that it is repeatable, and what is left when it is stopped.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::io::Cursor;
use std::process::Command;

use super::program::{changed, ffrf, scene, succeed};

#[test]
fn all_formats_hold_the_same_numbers_and_every_run_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let file = changed(folder.path(), "double_pendulum.toml", &[("duration = 5.0", "duration = 0.3")]);
    let endings = ["csv", "npz", "parquet"];
    for ending in endings {
        for run in ["a", "b"] {
            let (output, plot, motion) =
                (at(&format!("{run}.{ending}")), at(&format!("{run}.svg")), at(&format!("{run}.glb")));
            succeed(&["simulate", &file, "-o", &output, "--plot", &plot, "--animation", &motion]);
        }
    }
    for ending in endings.iter().chain(&["svg", "glb"]) {
        let [a, b] = ["a", "b"].map(|run| std::fs::read(at(&format!("{run}.{ending}"))).unwrap());
        assert_eq!(a, b, "{ending}");
    }
    let text = std::fs::read_to_string(at("a.csv")).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let parquet = std::fs::read(at("a.parquet")).unwrap();
    let mut archive = zip::ZipArchive::new(Cursor::new(std::fs::read(at("a.npz")).unwrap())).unwrap();
    assert_eq!(archive.len(), names.len());
    for (index, name) in names.iter().enumerate() {
        let column: Vec<f64> = rows.iter().map(|row| row[index]).collect();
        let npy = npyz::NpyFile::new(archive.by_name(&format!("{name}.npy")).unwrap()).unwrap();
        assert_eq!(npy.into_vec::<f64>().unwrap(), column, "{name}");
        let plain: Vec<u8> = column.iter().flat_map(|x| x.to_le_bytes()).collect();
        assert!(parquet.windows(plain.len()).any(|window| window == plain), "{name}");
    }
    let picture = std::fs::read_to_string(at("a.svg")).unwrap();
    for said in ["<svg", "elbow_angle", "energies", "time / s", "position / m"] {
        assert!(picture.contains(said), "{said}");
    }
}

#[test]
fn an_animation_moves_bodies_and_weighs_their_modes() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let file = changed(folder.path(), "flexible_pendulum.toml", &[("duration = 0.5", "duration = 0.05")]);
    let (output, motion) = (at("o.csv"), at("m.glb"));
    succeed(&[
        "simulate",
        &file,
        "-o",
        &output,
        "--animation",
        &motion,
        "--playback",
        "3",
        "--deformation-scale",
        "20",
    ]);
    let bytes = std::fs::read(&motion).unwrap();
    assert_eq!((&bytes[..4], bytes.len() % 4), (&b"glTF"[..], 0));
    let word = |place: usize| u32::from_le_bytes(bytes[place..place + 4].try_into().unwrap()) as usize;
    assert_eq!((word(4), word(8)), (2, bytes.len()));
    let document: serde_json::Value = serde_json::from_slice(&bytes[20..20 + word(12)]).unwrap();
    let accessor = |index: &serde_json::Value| &document["accessors"][index.as_u64().unwrap() as usize];
    let animation = &document["animations"][0];
    let mut paths = Vec::new();
    for channel in animation["channels"].as_array().unwrap() {
        let sampler = &animation["samplers"][channel["sampler"].as_u64().unwrap() as usize];
        let (times, values) = (accessor(&sampler["input"]), accessor(&sampler["output"]));
        assert_eq!(times["max"][0], 3.0);
        let path = channel["target"]["path"].as_str().unwrap();
        let modes = document["meshes"][0]["primitives"][0]["targets"].as_array().unwrap().len();
        let each = if path == "weights" { modes as u64 } else { 1 };
        assert_eq!(values["count"].as_u64(), times["count"].as_u64().map(|count| count * each));
        paths.push(path);
    }
    assert_eq!(paths, ["translation", "rotation", "weights"]);
    for view in document["bufferViews"].as_array().unwrap() {
        let end = view["byteOffset"].as_u64().unwrap() + view["byteLength"].as_u64().unwrap();
        assert!(end <= document["buffers"][0]["byteLength"].as_u64().unwrap());
    }
}

#[test]
fn a_run_split_in_two_is_the_whole_run_with_every_integrator() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    for (name, setting) in [
        ("dopri5", "tolerance = 1e-7"),
        ("rk4", "step = 2e-3"),
        ("linearly_implicit", "step = 2e-3"),
        ("generalized_alpha", "step = 2e-3"),
    ] {
        let setting = format!("{setting}\nintegrator = \"{name}\"");
        let scene = |duration: &str| {
            let duration = format!("duration = {duration}");
            let changes = [("tolerance = 1e-9", setting.as_str()), ("duration = 5.0", duration.as_str())];
            changed(folder.path(), "double_pendulum.toml", &changes)
        };
        let (half, whole) = (scene("0.25"), scene("0.5"));
        succeed(&["simulate", &whole, "-o", &at("whole.csv"), "--save-state", &at("whole.json")]);
        succeed(&["simulate", &half, "-o", &at("half.csv"), "--save-state", &at("half.json")]);
        let (from, end) = (at("half.json"), at("rest.json"));
        succeed(&["simulate", &whole, "-o", &at("rest.csv"), "--load-state", &from, "--save-state", &end]);
        let read = |name: &str| std::fs::read_to_string(at(name)).unwrap();
        assert_eq!(read("whole.json"), read("rest.json"), "{name}");
        // the second half begins with the sample that the first one ended with
        let (whole, half, rest) = (read("whole.csv"), read("half.csv"), read("rest.csv"));
        let joined: Vec<&str> = half.lines().chain(rest.lines().skip(2)).collect();
        assert_eq!(whole.lines().collect::<Vec<_>>(), joined, "{name}");
        assert_eq!(half.lines().last(), rest.lines().nth(1), "{name}");
    }
}

#[test]
fn names_that_end_in_something_else_are_refused_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let file = scene("double_pendulum.toml");
    for (arguments, expected) in [
        (vec!["-o", &at("a.xlsx")], "expected a name that ends in .csv, .npz or .parquet, found .xlsx"),
        (vec!["-o", &at("a.csv"), "--plot", &at("a.png")], "ends in .svg"),
        (vec!["-o", &at("a.csv"), "--animation", &at("a.vtu")], "ends in .html or .glb"),
    ] {
        let arguments: Vec<&str> = ["simulate", &file].into_iter().chain(arguments).collect();
        let run = ffrf(&arguments);
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(1), "{said}");
        assert!(said.contains(expected), "{said}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[cfg(unix)]
#[test]
fn a_run_that_is_interrupted_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("o.csv");
    // hours of work
    let file = changed(folder.path(), "slider_crank.toml", &[("duration = 0.02 ", "duration = 2000.0 ")]);
    let mut child = Command::new(env!("CARGO_BIN_EXE_ffrf"))
        .args(["simulate", &file, "-o", &output.display().to_string()])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(400));
    assert!(child.try_wait().unwrap().is_none(), "it runs");
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert!(!child.wait().unwrap().success());
    let left: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left.len(), 1, "the scene alone: {left:?}");
}
