//! `ffrf tradeoff`: what a sweep finds, that one that was killed goes on, and refusals.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::workbench::{Run, Workbench};

fn model(name: &str) -> String {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).display().to_string()
}

/// A beam, ten metres long, that swings about its clamped end for two seconds.
fn write_scene(bench: &Workbench) {
    let text = format!(
        r#"[simulation]
duration = 2.0
step = 1e-2
integrator = "linearly_implicit"
gravity = [0.0, 0.0, -9.81]
output_step = 0.05
[bodies.beam]
model = "{}"
[joints.hub]
kind = "revolute"
first = "ground"
second = "beam"
axis = [0.0, 1.0, 0.0]
[sensors.tip]
kind = "position"
of = "beam.TIP"
[sensors.hub]
kind = "reaction_force"
of = "hub"
"#,
        model("spin_up_beam.ffrf.json")
    );
    bench.write("scene.toml", &text);
}

const GRID: [&str; 8] = [
    "--modes=0,3,4",
    "--fidelity=linear,full",
    "--scalar=f64,f32",
    "--integrator=linearly_implicit,rk4",
    "--step=2e-2,5e-3",
    "--reference-tolerance=1e-8",
    "--quantity=tip",
    "--quantity=energy",
];

fn sweep(bench: &Workbench, folder: &str) -> Run {
    let mut arguments = vec!["tradeoff", "scene.toml", "-o", folder];
    arguments.extend(GRID);
    bench.run_words(arguments)
}

/// A CSV file by its columns.
fn columns(path: &Path) -> BTreeMap<String, Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for line in lines {
        let cells: Vec<&str> = line.splitn(names.len(), ',').collect();
        assert_eq!(cells.len(), names.len(), "{line}");
        for (name, cell) in names.iter().zip(cells) {
            found.entry((*name).to_owned()).or_default().push(cell.to_owned());
        }
    }
    found
}

/// A CSV file without what another run gives otherwise: times, and the front that is made of them.
fn without_times(path: &Path) -> BTreeMap<String, Vec<String>> {
    let mut found = columns(path);
    for name in ["time_per_second", "front_time"] {
        found.remove(name).unwrap();
    }
    found
}

#[test]
fn a_sweep_finds_that_modes_and_small_steps_are_exact_and_that_explicit_large_steps_fail() {
    let bench = Workbench::new();
    write_scene(&bench);
    let said = sweep(&bench, "out").succeeded();
    assert!(said.contains("its own error"), "{said}");
    for name in [
        "table.txt",
        "table.csv",
        "report.html",
        "pareto_operations.svg",
        "pareto_time.svg",
        "work_precision_operations.svg",
        "work_precision_time.svg",
    ] {
        assert!(bench.path("out").join(name).is_file(), "{name}");
    }
    let found = columns(&bench.path("out/table.csv"));
    // without modes all fidelities are one body: (1 + 2 · 2) bodies · 2 scalars · 2 integrators · 2 steps
    assert_eq!(found["modes"].len(), 40);
    let error = |modes: &str, integrator: &str, step: &str| -> f64 {
        let k = (0..40).find(|k| {
            found["modes"][*k] == modes
                && found["fidelity"][*k] == "full"
                && found["scalar"][*k] == "f64"
                && found["integrator"][*k] == integrator
                && found["longest_step"][*k] == step
        });
        found["error"][k.unwrap()].parse().unwrap_or(f64::INFINITY)
    };
    // the rigid pendulum is off by what its beam bends, which no step mends
    let rigid = error("0", "rk4", "5e-3");
    assert!(rigid > 1e-4, "{rigid}");
    assert!((error("0", "rk4", "2e-2") / rigid - 1.0).abs() < 0.05);
    // of order 2, where nothing else is wrong
    let (coarse, fine) = (error("4", "linearly_implicit", "2e-2"), error("4", "linearly_implicit", "5e-3"));
    assert!(fine < 0.25 * coarse, "{coarse} {fine}");
    // the fourth mode, at 121 Hz, lets rk4 take 2.83 / (2π · 121 Hz) = 3.7 ms
    assert!(error("4", "rk4", "5e-3").is_infinite() && error("3", "rk4", "5e-3") < rigid);
    // every run has an error or a reason
    for k in 0..40 {
        assert!(found["error"][k].is_empty() != found["failure"][k].is_empty(), "{k}");
    }
    let page = fs::read_to_string(bench.path("out/report.html")).unwrap();
    assert!(!page.contains("http://") || page.matches("http://").count() == 1, "only the name of SVG");
    assert!(!page.contains("https://") && page.contains("\"rows\":["));
}

#[test]
fn a_sweep_that_is_killed_goes_on_and_ends_as_if_nothing_had_been() {
    let bench = Workbench::new();
    write_scene(&bench);
    sweep(&bench, "whole").succeeded();
    let runs = bench.path("killed/runs");
    let start = || {
        Command::new(env!("CARGO_BIN_EXE_ffrf"))
            .args(["tradeoff", "scene.toml", "-o", "killed", "--threads=2"])
            .args(GRID)
            .current_dir(bench.path(""))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    // whenever it comes: before the folder is there, in the reference, while a file is written
    let mut moment =
        std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap().as_nanos() as u64;
    for _ in 0..4 {
        moment = moment.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let pause = Duration::from_micros((moment >> 33) % 60_000);
        eprintln!("killed after {pause:?}");
        let mut child = start();
        std::thread::sleep(pause);
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let mut child = start();
    let begin = Instant::now();
    let kept = || -> Vec<String> {
        let files = fs::read_dir(&runs).into_iter().flatten().map(Result::unwrap).filter(is_run);
        files.map(|file| fs::read_to_string(file.path()).unwrap()).collect()
    };
    let count = || kept().iter().map(|text| text.lines().count()).sum::<usize>();
    while count() < 5 && begin.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let before = count();
    assert!((5..40).contains(&before), "killed after {before} of 40 runs");
    for text in kept() {
        assert!(text.ends_with("}\n"), "a run is whole or not there: {text}");
    }
    let said = sweep(&bench, "killed").succeeded();
    assert!(said.contains(&format!("40 runs, {before} of them here before")), "{said}");
    assert_eq!(without_times(&bench.path("killed/table.csv")), without_times(&bench.path("whole/table.csv")));
    // with nothing left to do every byte is the same, times too
    let table = fs::read(bench.path("killed/table.csv")).unwrap();
    let page = fs::read(bench.path("killed/report.html")).unwrap();
    sweep(&bench, "killed").succeeded();
    assert_eq!(fs::read(bench.path("killed/table.csv")).unwrap(), table);
    assert_eq!(fs::read(bench.path("killed/report.html")).unwrap(), page);
}

fn is_run(one: &fs::DirEntry) -> bool {
    one.file_name().to_string_lossy().ends_with(".jsonl")
}

#[test]
fn another_scene_in_the_same_folder_and_unknown_quantities_are_refused() {
    let bench = Workbench::new();
    write_scene(&bench);
    let short =
        ["--modes=0", "--scalar=f64", "--step=2e-2", "--integrator=rk4", "--reference-tolerance=1e-6"];
    let with = |more: &[&str]| {
        let mut arguments = vec!["tradeoff", "scene.toml", "-o", "out"];
        arguments.extend(short);
        arguments.extend(more);
        bench.run_words(arguments)
    };
    with(&[]).succeeded();
    with(&["--quantity=energy"]).failed(1, &["out", "other quantities"]);
    with(&["--quantity=sensor root"]).failed(1, &["`root`", "`tip`", "`hub`", "`energy`"]);
    let text = fs::read_to_string(bench.path("scene.toml")).unwrap();
    bench.write("scene.toml", &text.replace("-9.81", "-1.62"));
    with(&[]).failed(1, &["out", "another scene"]);
    bench.run("tradeoff scene.toml -o out --step=-1").failed(2, &["positive"]);
    bench.run("tradeoff scene.toml -o out --scalar=generic").failed(2, &["f64 or f32"]);
}

/// A beam of four modes on a hinge, and at its tip a part of three.
pub fn write_two_bodies(bench: &Workbench) {
    bench
        .run("reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 3 --marker END=3,4,5 -o part.ffrf.json")
        .succeeded();
    write_scene(bench);
    let text = bench.read("scene.toml")
        + "[bodies.part]\nmodel = \"part.ffrf.json\"\nposition = [10.0, 0.0, 0.0]\n\
           [joints.hook]\nkind = \"revolute\"\nfirst = \"beam.TIP\"\nsecond = \"part\"\naxis = [0.0, 1.0, 0.0]\n\
           [sensors.end]\nkind = \"position\"\nof = \"part.END\"\n";
    bench.write("scene.toml", &text.replace("duration = 2.0", "duration = 0.5"));
}

#[test]
fn bodies_have_modes_of_their_own() {
    let bench = Workbench::with_part();
    write_two_bodies(&bench);
    let grid = "tradeoff scene.toml -o out --fidelity=full --scalar=f64 --integrator=linearly_implicit --step=1e-3 \
                --reference-tolerance=1e-8 --quantity=tip --quantity=end";
    bench.run(&format!("{grid} --modes=beam=0,2,4 --modes part=0,[0,2],3")).succeeded();
    let names = [
        "0",
        "beam=0 part=[0+2]",
        "beam=0 part=3",
        "beam=2 part=0",
        "beam=2 part=[0+2]",
        "beam=2 part=3",
        "beam=4 part=0",
        "beam=4 part=[0+2]",
        "4",
    ];
    let found = columns(&bench.path("out/table.csv"));
    assert_eq!(found["modes"], names);
    let error = |modes: &str| -> f64 {
        let row = found["modes"].iter().position(|name| name == modes).unwrap();
        found["error"][row].parse().unwrap()
    };
    // each body has what it is given: the beam bends, the part is stiff, and its modes do not stand in for those of the beam
    for row in 0..names.len() {
        let has_beam = row >= 6;
        assert_eq!(error(names[row]) < 1e-4, has_beam, "{found:?}");
        assert_eq!(error(names[row]) > 1e-3, !has_beam, "{found:?}");
    }
    assert!(error("4") != error("beam=4 part=0") && error("0") != error("beam=0 part=3"));
    let table = bench.read("out/table.txt");
    let begins: Vec<usize> = table
        .lines()
        .filter_map(|line| line.find(" full ").filter(|_| line.contains("linearly_implicit")))
        .collect();
    assert!(begins.len() == names.len() && begins.iter().all(|begin| *begin == begins[0]), "{table}");
    assert!(bench.read("out/report.html").contains(r#""modes":"beam=2 part=[0, 2]""#));
    // what is done is known again, whichever way it is asked for
    let again = bench.run(&format!("{grid} --modes beam=4 --modes 1,4")).succeeded();
    assert!(again.contains("2 runs, 1 of them here before"), "{again}");
    let again = bench.run(&format!("{grid} --modes part=[2,0]")).succeeded();
    assert!(again.contains("1 runs, 1 of them here before"), "{again}");
    bench
        .run(&format!("{grid} --modes rod=2"))
        .failed(1, &["scene.toml", "modes of `rod`", "`beam`, `part`"]);
    bench.run(&format!("{grid} --modes beam=x")).failed(2, &["--modes"]);
}

/// Three of four modes against all four must be off by the same, whether the scene has four and a configuration takes three, or the
/// scene has a body of three and the reference another model.
#[test]
fn modes_that_the_scene_does_not_have_are_in_the_reference_that_another_model_gives() {
    let bench = Workbench::new();
    write_scene(&bench);
    let whole = model("spin_up_beam.ffrf.json");
    let small = ffrf_model::ReducedBody::read(&whole).unwrap().with_modes(3).unwrap();
    small.write(bench.path("small.ffrf.json")).unwrap();
    bench.write("small.toml", &bench.read("scene.toml").replace(&whole, "small.ffrf.json"));
    let grid = [
        "--fidelity=full",
        "--scalar=f64",
        "--integrator=rk4",
        "--step=5e-4",
        "--reference-tolerance=1e-8",
        "--quantity=tip",
    ];
    let run = |scene: &str, folder: &str, more: &[&str]| {
        let head = ["tradeoff", scene, "-o", folder, "--modes=3"];
        bench.run_words(head.iter().chain(&grid).chain(more).copied())
    };
    let error =
        |folder: &str| -> f64 { columns(&bench.path(folder).join("table.csv"))["error"][0].parse().unwrap() };
    run("scene.toml", "four", &[]).succeeded();
    run("small.toml", "three", &[]).succeeded();
    let of_reference = format!("--reference-model=beam={whole}");
    run("small.toml", "against", &[&of_reference]).succeeded();
    let [four, three, against] = ["four", "three", "against"].map(error);
    println!("{four:e} {three:e} {against:e}");
    assert!(three < 0.1 * four, "three modes against themselves: {three:e}, against four: {four:e}");
    assert!((against / four - 1.0).abs() < 1e-9, "{against:e}, expected {four:e}");

    // what is in a folder is of one reference
    run("small.toml", "three", &[&of_reference]).failed(1, &["other models or tables"]);
    for (wrong, told) in [
        ("--reference-model=hub=small.ffrf.json", "no such flexible body"),
        ("--reference-model=beam=nowhere.ffrf.json", "nowhere.ffrf.json"),
    ] {
        run("small.toml", "wrong", &[wrong]).failed(1, &[told]);
    }
    run("small.toml", "wrong", &[&of_reference, &of_reference]).failed(1, &["two models of body `beam`"]);
    run("small.toml", "wrong", &["--reference-model=beam"]).failed(2, &["BODY=MODEL"]);
    bench.write(
        "bent.toml",
        &bench.read("small.toml").replace("[joints", "modal_coordinates = [0.1, 0.0, 0.0]\n[joints"),
    );
    run("bent.toml", "wrong", &[&of_reference]).failed(1, &["begins deformed"]);
}

/// What was counted on cores stands beside the runs of its programs, whatever their steps; the rest of the sweep does not wait
/// for tools that are not there.
#[test]
fn counts_on_a_core_are_columns_of_the_runs_and_are_asked_for_after_them() {
    let bench = Workbench::new();
    write_scene(&bench);
    let grid = [
        "--modes=0,[0+3]",
        "--fidelity=full",
        "--scalar=f32",
        "--integrator=rk4,generalized_alpha",
        "--step=2e-2,1e-3",
        "--reference-tolerance=1e-6",
        "--quantity=tip",
    ];
    let with = |more: &[&str]| {
        let mut arguments = vec!["tradeoff", "scene.toml", "-o", "out"];
        arguments.extend(grid);
        arguments.extend(more);
        bench.run_words(arguments)
    };
    with(&["--target=cortex-m7", "--sources=nowhere"]).failed(1, &["cortex-m7", "--sources nowhere"]);
    let before = columns(&bench.path("out/table.csv"));
    assert!(before.keys().all(|name| !name.contains("cortex")));
    assert_eq!(before["modes"].iter().filter(|modes| *modes == "[0+3]").count(), 4);
    // as it is kept after a count
    bench.write(
        "out/target.json",
        r#"{"cortex-m7":{
            "m.0.3-full-f32-rk4":{"counted":{"instructions":20000,"code":9000,"tables":16,"state":400,"stack":1200,"stack_bound":1500}},
            "m0-full-f32-rk4":{"failed":"region FLASH overflowed"}}}"#,
    );
    with(&[]).succeeded();
    let after = columns(&bench.path("out/table.csv"));
    let mut counted = 0;
    for k in 0..after["modes"].len() {
        let of = |name: &str| after[&format!("cortex-m7.{name}")][k].clone();
        let found =
            ["instructions_per_step", "code_bytes", "data_bytes", "stack_bytes", "stack_bytes_at_most"]
                .map(of);
        let is_counted =
            after["modes"][k] == "[0+3]" && after["integrator"][k] == "rk4" && after["failure"][k].is_empty();
        let expected = ["20000", "9000", "416", "1200", "1500"];
        assert_eq!(found, if is_counted { expected } else { [""; 5] }, "{k}");
        counted += usize::from(is_counted);
        // nothing else has moved
        assert_eq!(after["error"][k], before["error"][k]);
        assert_eq!(after["failure"][k], before["failure"][k]);
    }
    assert!(counted > 0, "no run of the counted program reached its end");
    let table = fs::read_to_string(bench.path("out/table.txt")).unwrap();
    assert!(table.contains("cortex-m7: a step as counted"), "{table}");
    assert!(table.contains("not counted: region FLASH overflowed"), "{table}");
    let page = fs::read_to_string(bench.path("out/report.html")).unwrap();
    assert!(page.contains(r#""cores":["cortex-m7"]"#) && page.contains(r#""code":9000"#), "{page}");
    bench.run("tradeoff scene.toml -o out --sources=.").failed(2, &["--target"]);
    bench.run("tradeoff scene.toml -o out --modes=[0+9x]").failed(2, &["for a list (from 0)"]);
}
