//! What `inspect` tells of a body: units, frequencies and steps, and how its files were read.
#![allow(clippy::unwrap_used)]
#![allow(clippy::panic)] // helpers of tests are tests

use crate::workbench::Workbench;
use serde_json::Value;

const REDUCE: &str = "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx -o body.ffrf.json";

fn inspected(options: &str) -> (Workbench, String) {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} {options}")).succeeded();
    let text = bench.run("inspect body.ffrf.json").succeeded();
    (bench, text)
}

/// What follows a label.
#[track_caller]
fn row<'a>(text: &'a str, label: &str) -> &'a str {
    let rows: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix(label)).collect();
    match rows.as_slice() {
        [row] => row.trim(),
        _ => panic!("{} rows `{label}` in: {text}", rows.len()),
    }
}

fn number(row: &str) -> f64 {
    row.split(' ').next().unwrap().parse().unwrap()
}

#[test]
fn every_row_has_its_units_or_units_are_said_to_be_unknown() {
    let (_, text) = inspected("--modes 3 --marker tip=5 --units mm,t,s");
    assert_eq!(row(&text, "units"), "mm, t, s, N");
    assert_eq!(row(&text, "mass  "), "12.500000 t");
    assert!(row(&text, "centre of mass").ends_with(" mm"), "{text}");
    assert!(row(&text, "inertia about origin").ends_with(" t mm^2"), "{text}");
    assert!(row(&text, "marker").ends_with(" mm"), "{text}");
    assert!(row(&text, "largest stable step").contains(" s for the classical Runge-Kutta"), "{text}");
    let (_, text) = inspected("--modes 3");
    assert!(row(&text, "units").starts_with("unknown: "), "{text}");
    assert_eq!(row(&text, "mass  "), "12.500000");
    assert!(row(&text, "highest frequency").contains(" per unit of time "), "{text}");
}

#[test]
fn the_highest_frequency_and_the_step_that_it_allows_are_told() {
    let (bench, text) = inspected("--modes 12 --units SI");
    let body: Value = serde_json::from_str(&bench.read("body.ffrf.json")).unwrap();
    // All elastic modes of the free part: nothing couples them, and the last is the highest.
    let last = body["modes"][11]["frequency_hz"].as_f64().unwrap();
    let highest = row(&text, "highest frequency");
    assert!(highest.contains(" Hz of the free body"), "{highest}");
    // Printed to six digits.
    assert!((number(highest) / last - 1.0).abs() < 1e-5, "{highest}, expected {last}");
    let step = row(&text, "largest stable step");
    assert!(step.contains("step_rk4"), "{step}");
    let expected = 2.785 / (std::f64::consts::TAU * last);
    assert!((number(step) / expected - 1.0).abs() < 1e-2, "{step}, expected {expected:e}");
    // Fewer modes, a longer step.
    let fewer = bench.run("inspect body.ffrf.json --modes 4").succeeded();
    assert!(number(row(&fewer, "largest stable step")) > number(step), "{fewer}");
}

#[test]
fn generated_documentation_is_in_the_units_of_the_model() {
    let documented = |options: &str| {
        let (bench, _) = inspected(&format!("--modes 2 --marker tip=5 {options}"));
        bench.run("generate body.ffrf.json").succeeded()
    };
    let text = documented("--units mm,t,s");
    for part in
        ["// Units: mm, t, s, N\n", "Mass m. Units: t.", "Units: N, N mm, modal forces", "`tip`. Units: mm,"]
    {
        assert!(text.contains(part), "`{part}` is not in: {text}");
    }
    assert!(!text.contains("kg"), "{text}");
    let text = documented("");
    for part in ["// Units: unknown; ", "Mass m. Units: mass.", "Units: force, force length, modal forces"] {
        assert!(text.contains(part), "`{part}` is not in: {text}");
    }
    assert!(!text.contains("kg"), "{text}");
    assert!(documented("--units SI").contains("Mass m. Units: kg."));
}

#[test]
fn frequencies_of_a_body_are_in_hertz_whatever_the_unit_of_time_is() {
    let frequency = |options: &str| {
        let bench = Workbench::with_part();
        let said = bench.run(&format!("{REDUCE} --modes 2 {options}")).succeeded();
        let body: Value = serde_json::from_str(&bench.read("body.ffrf.json")).unwrap();
        (body["modes"][0]["frequency_hz"].as_f64().unwrap(), said)
    };
    let ((seconds, said), (milliseconds, remarked)) =
        (frequency("--units SI"), frequency("--units mm,kg,ms"));
    assert!((milliseconds / (1000.0 * seconds) - 1.0).abs() < 1e-15, "{seconds} {milliseconds}");
    assert!(remarked.contains("cycles per ms") && !said.contains("cycles per"), "{remarked}");
}

#[test]
fn how_a_file_was_read_goes_into_the_model_and_no_name_steers_the_terminal() {
    let bench = Workbench::with_part();
    let list: String = bench.read("M.mtx").lines().skip(2).map(|line| format!("{line}\n")).collect();
    let name = "M\u{1b}[31m\nmass\u{202e}.txt";
    bench.write(name, &list);
    let words =
        ["reduce", "--nodes", "X.txt", "--mass", name, "--mass-form", "scalar", "--stiffness", "K.mtx"];
    let rest = ["--modes", "2", "--title", "a\nmass   1000 kg\u{7}", "-o", "body.ffrf.json"];
    let run = bench.run_words(words.into_iter().chain(rest));
    let raw = |text: &str| text.contains(|c: char| c != '\n' && (c.is_control() || c == '\u{202e}'));
    let escaped = "M\\u{1b}[31m\\u{a}mass\\u{202e}.txt: a list without a header, read as `row column value`";
    assert!(run.stderr.contains(&format!("note: {escaped}")) && !raw(&run.stderr), "{}", run.stderr);
    assert!(!raw(&run.stdout), "{}", run.stdout);
    run.succeeded();
    let body: Value = serde_json::from_str(&bench.read("body.ffrf.json")).unwrap();
    let notes = body["provenance"]["notes"].as_array().unwrap();
    assert!(notes[0].as_str().unwrap().starts_with(escaped), "{notes:?}");
    let shown = bench.run("inspect body.ffrf.json").succeeded();
    assert!(row(&shown, "note").starts_with(escaped) && !raw(&shown), "{shown}");
    assert_eq!(row(&shown, "mass  "), "12.500000");
    // A sound file says all by itself.
    bench.run(&format!("{REDUCE} --modes 2")).succeeded();
    assert!(!bench.read("body.ffrf.json").contains("\"notes\""));
}

#[test]
fn errors_of_a_model_file_are_one_line_of_plain_text() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --modes 2 --marker tip=1")).succeeded();
    let good = bench.read("body.ffrf.json");
    for (from, to, shown) in [
        ("\"title\"", "\"ti\\ntle\\u001b[2J\"", "ti\\u{a}tle\\u{1b}[2J"),
        ("\"name\": \"tip\"", "\"name\": \"ti\\u001b[2J\\u202ep\"", "ti\\u{1b}[2J"),
        ("\"kind\": \"free-free\"", "\"kind\": \"\\u001b[2J\"", "\\u{1b}[2J"),
    ] {
        assert!(good.contains(from));
        bench.write("body.ffrf.json", &good.replacen(from, to, 1));
        for command in
            ["generate body.ffrf.json", "evaluate body.ffrf.json states.json", "inspect body.ffrf.json"]
        {
            let run = bench.run(command);
            let complaint = run.stderr;
            assert_eq!(run.code, 1, "{complaint}");
            assert!(complaint.contains(shown), "{command}: `{shown}` is not in: {complaint}");
            let raw = complaint.contains(|c: char| c != '\n' && (c.is_control() || c == '\u{202e}'));
            let added = complaint.lines().skip(1).find(|line| !line.starts_with("  caused by: "));
            assert!(!raw && added.is_none(), "{complaint:?}");
        }
    }
}
