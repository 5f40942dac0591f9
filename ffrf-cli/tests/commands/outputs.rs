//! Where results go: files, devices, pipes and readers that go away.
#![cfg(unix)]
#![allow(clippy::unwrap_used)]

use std::io::Read;
use std::os::unix::fs::{FileTypeExt, PermissionsExt};
use std::process::{Command, Stdio};

use crate::workbench::Workbench;

const REDUCE: &str = "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 2 -o";
const STATES: &str = r#"{"states":[{"q":[0,0],"omega":[0,0,1],"q_dot":[0,0],"force":[0,0,0,0,0,0,0,0]}]}"#;

/// A folder with a body and states, and each command that writes a file.
fn commands() -> (Workbench, [&'static str; 3]) {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} body.ffrf.json")).succeeded();
    bench.write("states.json", STATES);
    (bench, [REDUCE, "generate body.ffrf.json -o", "evaluate body.ffrf.json states.json -o"])
}

fn shell(bench: &Workbench, script: &str) -> (i32, String, String) {
    let output = Command::new("sh")
        .args(["-c", script])
        .env("FFRF", env!("CARGO_BIN_EXE_ffrf"))
        .current_dir(bench.path("."))
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_full_device_is_an_error_and_stays_a_device() {
    if std::fs::metadata("/dev/full").is_err() {
        eprintln!("SKIPPED: there is no /dev/full here");
        return;
    }
    let (bench, commands) = commands();
    for command in commands {
        bench.run(&format!("{command} /dev/full")).failed(1, &["/dev/full", "No space left"]);
        assert!(std::fs::metadata("/dev/full").unwrap().file_type().is_char_device());
        bench.run(&format!("{command} /dev/null")).succeeded();
        assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }
    let (code, _, complaint) = shell(&bench, "$FFRF inspect body.ffrf.json > /dev/full");
    assert_eq!(code, 1);
    assert!(complaint.contains("standard output") && complaint.contains("No space left"), "{complaint}");
}

#[test]
fn a_named_pipe_is_written_to() {
    let (bench, commands) = commands();
    for (number, command) in commands.into_iter().enumerate() {
        bench.run(&format!("{command} out")).succeeded();
        let pipe = format!("pipe{number}");
        assert!(Command::new("mkfifo").arg(bench.path(&pipe)).status().unwrap().success());
        let path = bench.path(&pipe);
        let reader = std::thread::spawn(move || {
            let mut text = String::new();
            std::fs::File::open(path).unwrap().read_to_string(&mut text).unwrap();
            text
        });
        bench.run(&format!("{command} {pipe}")).succeeded();
        assert_eq!(reader.join().unwrap(), bench.read("out"), "{command}");
        assert!(std::fs::metadata(bench.path(&pipe)).unwrap().file_type().is_fifo());
    }
}

#[test]
fn standard_output_by_name_holds_the_result_alone() {
    let (bench, commands) = commands();
    for command in commands {
        bench.run(&format!("{command} out")).succeeded();
        let expected = bench.read("out");
        assert_eq!(bench.run(&format!("{command} /dev/stdout")).succeeded(), expected, "{command}");
        // What the file that the shell opened holds already stays.
        let script = format!("echo first > kept; $FFRF {command} /dev/stdout >> kept; cat kept");
        assert_eq!(shell(&bench, &script).1, format!("first\n{expected}"), "{command}");
    }
}

#[test]
fn a_read_only_file_is_not_replaced() {
    let (bench, commands) = commands();
    bench.write("precious", "old");
    std::fs::set_permissions(bench.path("precious"), std::fs::Permissions::from_mode(0o444)).unwrap();
    for command in commands {
        bench.run(&format!("{command} precious")).failed(1, &["precious", "read-only"]);
        assert_eq!(bench.read("precious"), "old");
    }
}

#[test]
fn what_a_killed_run_left_behind_is_removed() {
    let (bench, commands) = commands();
    for command in commands {
        bench.write(".out.4194305-0.ffrf-tmp", "half");
        bench.run(&format!("{command} out")).succeeded();
        assert!(bench.files().iter().all(|name| !name.ends_with("ffrf-tmp")), "{:?}", bench.files());
    }
}

#[test]
fn a_reader_that_has_seen_enough_is_no_failure() {
    let (bench, _) = commands();
    let verify = "verify --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 2 body.ffrf.json";
    let commands = [
        "inspect body.ffrf.json",
        "generate body.ffrf.json",
        "evaluate body.ffrf.json states.json",
        verify,
        "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 2 -o again",
        "inspect --help",
    ];
    for command in commands {
        let mut child = Command::new(env!("CARGO_BIN_EXE_ffrf"))
            .args(command.split(' '))
            .current_dir(bench.path("."))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // The reading end is closed before anything is written, or after.
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let complaint = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), complaint.as_str()), (Some(0), ""), "{command}");
    }
    // The file is written all the same.
    assert_eq!(bench.read("again"), bench.read("body.ffrf.json"));
}

#[test]
fn bad_input_does_not_reach_the_terminal_raw() {
    let bench = Workbench::with_part();
    let raw = |text: &str| text.contains('\u{1b}') || text.contains('\r') || text.contains('\u{202e}');
    let nodes = bench.read("X.txt");
    bench.write("X.txt", &format!("0 \u{1b}[2J\u{202e}0 0\n{nodes}"));
    let run = bench.run(&format!("{REDUCE} body.ffrf.json"));
    assert!(run.stderr.contains("\\u{1b}[2J") && !raw(&run.stderr), "{}", run.stderr);
    let run = bench.run_words(["inspect", "\u{1b}[31mnothing"]);
    assert!(run.stderr.contains("\\u{1b}[31mnothing") && !raw(&run.stderr), "{}", run.stderr);
    let run = bench.run_words(["reduce", "--modes", "\u{1b}[31m"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("--modes") && !raw(&run.stderr), "{}", run.stderr);
    // What a sound model holds in words is shown, and stands in comments of the code.
    bench.write("X.txt", &nodes);
    bench
        .run_words(REDUCE.split(' ').chain(["body.ffrf.json", "--title", "red\u{1b}[31m\nfn evil() {}"]))
        .succeeded();
    let shown = bench.run("inspect body.ffrf.json").succeeded();
    assert!(shown.contains("red\\u{1b}[31m") && !raw(&shown), "{shown}");
    let code = bench.run("generate body.ffrf.json").succeeded();
    assert!(!raw(&code) && !code.lines().any(|line| line.starts_with("fn evil")), "{code}");
}

#[test]
fn generated_c_is_a_source_and_a_header_called_after_the_body() {
    let bench = Workbench::with_part();
    bench.run("reduce --nodes X.txt --mass M.mtx --stiffness K.mtx -o body.ffrf.json --modes 2").succeeded();
    bench.run("generate body.ffrf.json --language c --name TestRod -o rod.c").succeeded();
    assert!(bench.read("rod.c").contains("#include \"test_rod.h\""));
    assert!(bench.read("test_rod.h").contains("void test_rod_forward_dynamics("));
    let both = bench.run("generate body.ffrf.json --language c").succeeded();
    assert!(
        both.contains("#ifndef BODY_H")
            && both.contains("double body_kinetic_energy(")
            && !both.contains("#include \"body.h\"")
    );
    bench.run("generate body.ffrf.json --language c -o rod.h").failed(1, &["rod.h", "NAME.c"]);
    bench
        .run("generate body.ffrf.json --language c --scalar generic")
        .failed(1, &["body.ffrf.json", "generic", "f64 or f32"]);
    bench.run("generate --layout damping=zero --modes 2 --language c").failed(1, &["--language c", "model"]);
}

#[test]
fn generated_c_of_a_scene_is_the_step_of_its_mechanism() {
    let bench = Workbench::with_part();
    let scene = "[simulation]\nduration = 1.0\nstep = 1e-3\n[bodies.arm]\nmass = 1.0\ncenter_of_mass = [0.5, 0.0, 0.0]\n\
                 inertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\n\
                 [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"arm\"\n";
    bench.write("arm.toml", scene);
    bench.run("generate arm.toml --language c --name TestArm --scalar f32 -o arm.c").succeeded();
    assert!(bench.read("arm.c").contains("#include \"test_arm.h\""));
    let header = bench.read("test_arm.h");
    assert!(
        header
            .contains("int test_arm_step(test_arm_state *state, const test_arm_inputs *inputs, float step);")
    );
    assert!(header.contains("TEST_ARM_BODY_ARM = 0") && header.contains("Scene: arm.toml"), "{header}");
    let both = bench.run("generate arm.toml --language c").succeeded();
    assert!(both.contains("int mechanism_step(") && !both.contains("#include \"mechanism.h\""));
    let rust = bench.run("generate arm.toml").succeeded();
    assert!(rust.contains("pub struct Arm {") && rust.contains("pub fn arm_accelerations("), "{rust}");
    bench.run("generate arm.toml --language c --modes 2").failed(1, &["--modes", "in the scene"]);
    bench.write("arm.toml", &scene.replace("step =", "integrator = \"energy_momentum\"\nstep ="));
    bench
        .run("generate arm.toml --language c")
        .failed(1, &["simulation.integrator", "energy_momentum", "in generated C"]);
}
