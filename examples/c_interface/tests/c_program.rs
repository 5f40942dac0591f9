//! The C program of this example, compiled by every compiler that is there, gives the bits of the same run in Rust.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use ffrf::FlexibleBody;
use ffrf::nalgebra::Vector3;
use ffrf_c_interface::border;
use ffrf_c_interface::parts::{FreeRod, Rod, slider_crank};

/// Every warning that users' projects are likely to ask for is an error here.
const FLAGS: [&str; 8] =
    ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"];

fn show(text: &mut String, name: &str, numbers: impl IntoIterator<Item = f64>) {
    text.push_str(name);
    for number in numbers {
        write!(text, " {:016x}", number.to_bits()).unwrap();
    }
    text.push('\n');
}

/// The run of `main.c` by what Rust programs call.
fn run() -> String {
    let mut text = String::new();
    let mut crank = slider_crank();
    crank.model.motor.kind.moment = 0.2;
    for k in 0..105 {
        if k == 50 {
            crank.model.motor.kind.moment = -0.1;
        }
        crank.step_linearly_implicit(1e-3).unwrap();
        if k % 10 == 9 && k < 100 {
            let (stroke, time) = (crank.model.stroke(&crank.state), crank.time);
            let bearing = crank.model.bearing(time, &crank.state).unwrap();
            let numbers = [time].into_iter().chain(stroke.iter().copied()).chain(bearing.iter().copied());
            show(&mut text, "crank", numbers.chain([crank.state.crank.angular_velocity.z]));
        }
    }
    show(&mut text, "crank state", [crank.time, -0.1].into_iter().chain(crank.state.to_array()));
    let mut free = FreeRod::new(Vector3::new(0.0, 0.0, -9.81));
    free.push.force = Vector3::new(3.0, -20.0, 5.0);
    let step = 0.5 * FlexibleBody::<f64>::largest_stable_step(&Rod).unwrap();
    for k in 0..200 {
        if k == 100 {
            free.push.force = Vector3::zeros();
        }
        free.step(step).unwrap();
        if k % 20 == 19 {
            let tip = free.rod.marker_motion(&Rod::SMALL_END);
            let places = [free.rod.time].into_iter().chain(tip.position.iter().copied());
            let motion = places.chain(tip.velocity.iter().copied());
            show(&mut text, "rod", motion.chain([free.rod.kinetic_energy(), free.rod.elastic_energy()]));
        }
    }
    show(&mut text, "rod state", [free.rod.time, 0.0, 0.0, 0.0].into_iter().chain(free.rod.state.numbers()));
    text
}

/// The library that cargo has built for this test, and put beside it: the newest if there are several.
fn library() -> PathBuf {
    let folder = std::env::current_exe().unwrap().parent().unwrap().to_path_buf();
    let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap());
    let libraries = files.filter(|file| {
        let name = file.file_name().to_string_lossy().into_owned();
        name.starts_with("libffrf_c_interface") && name.ends_with(".a")
    });
    let newest = libraries.max_by_key(|file| file.metadata().unwrap().modified().unwrap());
    newest.unwrap_or_else(|| panic!("no library in {}", folder.display())).path()
}

#[test]
fn c_programs_get_the_bits_of_rust() {
    let expected = run();
    assert!(expected.lines().count() == 22 && !expected.contains("7ff8"), "{expected}");
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let library = library();
    let folder = tempfile::tempdir().unwrap();
    let mut tried = 0;
    for compiler in ["gcc", "clang"] {
        if Command::new(compiler).arg("--version").output().is_err() {
            eprintln!("SKIPPED: no {compiler} here");
            continue;
        }
        let program = folder.path().join(compiler);
        let output = Command::new(compiler)
            .args(FLAGS)
            .arg("-I")
            .arg(here.join("include"))
            .arg(here.join("main.c"))
            .arg(&library)
            .args(["-lm", "-lpthread", "-ldl", "-o"])
            .arg(&program)
            .output()
            .unwrap();
        assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
        let output = Command::new(&program).output().unwrap();
        assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(String::from_utf8(output.stdout).unwrap(), expected, "{compiler}");
        tried += 1;
    }
    assert!(tried > 0, "the check needs a C compiler (CONTRIBUTING.md)");
}

#[test]
fn headers_have_the_sizes_of_rust() {
    for (header, name, size) in [
        ("slider_crank.h", "SLIDER_CRANK_DOUBLES", border::slider_crank::DOUBLES),
        ("slider_crank.h", "SLIDER_CRANK_STATE", border::slider_crank::STATE),
        ("free_rod.h", "FREE_ROD_DOUBLES", border::free_rod::DOUBLES),
        ("free_rod.h", "FREE_ROD_STATE", border::free_rod::STATE),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include").join(header);
        let text = std::fs::read_to_string(path).unwrap();
        assert!(text.contains(&format!("#define {name} {size}\n")), "{header}: {name} is not {size}");
    }
}
