//! Generated C with a main function around it: compiled once, run for many inputs.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use ffrf_codegen::GeneratedC;
use ffrf_test_kit::c_compilers::{COMPILERS, FLAGS};

/// The compiler of a microcontroller and its core: if it is there, it must accept the code as well. What it makes runs
/// elsewhere.
const CROSS_COMPILER: &str = "arm-none-eabi-gcc";
/// A Cortex-M4F.
const CORE: [&str; 4] = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"];

/// All inputs that kernels have.
pub struct Inputs {
    pub q: Vec<f64>,
    pub velocity: Vec<f64>,
    pub omega: Vec<f64>,
    pub q_dot: Vec<f64>,
    pub force: Vec<f64>,
    pub gravity: Vec<f64>,
}

/// A compiled program that calls every function of a header.
pub struct CProgram {
    folder: tempfile::TempDir,
    functions: Vec<Function>,
}

struct Function {
    /// Without the prefix.
    name: String,
    inputs: Vec<(String, usize)>,
    outputs: Vec<(String, usize)>,
    returns: bool,
}

impl CProgram {
    /// Compiles with every compiler that is there; `None` if there is none.
    pub fn compile(code: &GeneratedC) -> Option<Self> {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let functions = functions(&code.header, &code.prefix);
        std::fs::write(path(&format!("{}.h", code.prefix)), &code.header).unwrap();
        std::fs::write(path("kernels.c"), &code.source).unwrap();
        std::fs::write(path("single.c"), &code.single).unwrap();
        std::fs::write(path("main.c"), main_program(&functions, code)).unwrap();
        let mut is_compiled = false;
        for compiler in COMPILERS.into_iter().filter(|compiler| is_here(compiler)) {
            let program = if is_compiled { "other" } else { "program" };
            compile(compiler, folder.path(), &["kernels.c", "main.c", "-lm", "-o", program]);
            compile(compiler, folder.path(), &["-c", "single.c", "-o", "single.o"]);
            is_compiled = true;
        }
        if is_here(CROSS_COMPILER) {
            for (source, object) in [("kernels.c", "kernels.o"), ("single.c", "cross.o")] {
                compile(CROSS_COMPILER, folder.path(), &[&CORE[..], &["-c", source, "-o", object]].concat());
            }
        }
        is_compiled.then_some(Self { folder, functions })
    }

    /// The results of every function, by its name.
    pub fn run(&self, inputs: &Inputs) -> Results {
        let mut text = String::new();
        for (name, size) in self.functions.iter().flat_map(|function| &function.inputs) {
            let values = match name.as_str() {
                "q" => &inputs.q,
                "velocity" => &inputs.velocity,
                "omega" => &inputs.omega,
                "q_dot" => &inputs.q_dot,
                "force" => &inputs.force,
                "gravity" => &inputs.gravity,
                other => panic!("unknown input {other}"),
            };
            assert_eq!(values.len(), *size, "{name}");
            values.iter().for_each(|value| writeln!(text, "{:016x}", value.to_bits()).unwrap());
        }
        let mut child = Command::new(self.folder.path().join("program"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success());
        let output = String::from_utf8(output.stdout).unwrap();
        let mut numbers = output.lines().map(|line| f64::from_bits(u64::from_str_radix(line, 16).unwrap()));
        let results = self.functions.iter().map(|function| {
            let count = function.outputs.iter().map(|(_, size)| (*size).max(1)).sum();
            (function.name.clone(), numbers.by_ref().take(count).collect())
        });
        Results(results.collect())
    }
}

/// Results in the order of the header.
pub struct Results(Vec<(String, Vec<f64>)>);

impl Results {
    pub fn len(&self) -> usize {
        self.0.len()
    }
}

impl<'a> IntoIterator for &'a Results {
    type Item = &'a (String, Vec<f64>);
    type IntoIter = std::slice::Iter<'a, (String, Vec<f64>)>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl std::ops::Index<&str> for Results {
    type Output = Vec<f64>;

    fn index(&self, name: &str) -> &Vec<f64> {
        let found = self.0.iter().find(|(known, _)| known == name);
        &found.unwrap_or_else(|| panic!("no result `{name}`")).1
    }
}

/// Whether there is such a compiler; says so if not.
fn is_here(compiler: &str) -> bool {
    let is_here = Command::new(compiler).arg("--version").output().is_ok();
    if !is_here {
        eprintln!("SKIPPED: no {compiler} here");
    }
    is_here
}

/// Compiles without a warning.
fn compile(compiler: &str, folder: &Path, arguments: &[&str]) {
    let output = Command::new(compiler).args(FLAGS).args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
}

/// The lines of numbers that a program about generated code (header, source, both in one text) prints, the same by every
/// compiler; none without a compiler.
pub fn printed(prefix: &str, [header, source, single]: [&str; 3], program: &str) -> Option<Vec<Vec<f64>>> {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path(&format!("{prefix}.h")), header).unwrap();
    std::fs::write(path("generated.c"), source).unwrap();
    std::fs::write(path("single.c"), single).unwrap();
    std::fs::write(path("main.c"), program).unwrap();
    if is_here(CROSS_COMPILER) {
        let arguments = [&CORE[..], &["-c", "generated.c", "-o", "cross.o"]].concat();
        compile(CROSS_COMPILER, folder.path(), &arguments);
    }
    let mut lines: Option<Vec<Vec<f64>>> = None;
    for compiler in COMPILERS.into_iter().filter(|compiler| is_here(compiler)) {
        compile(compiler, folder.path(), &["-c", "single.c", "-o", "single.o"]);
        compile(compiler, folder.path(), &["generated.c", "main.c", "-lm", "-o", compiler]);
        let output = Command::new(path(compiler)).output().unwrap();
        assert!(output.status.success(), "{compiler}: {:?}", output.status);
        let text = String::from_utf8(output.stdout).unwrap();
        let found: Vec<Vec<f64>> =
            text.lines().map(|line| line.split_whitespace().map(|x| x.parse().unwrap()).collect()).collect();
        // every compiler makes the same bits
        assert!(lines.is_none() || lines.as_ref() == Some(&found), "{compiler} computes otherwise");
        lines = Some(found);
    }
    lines
}

/// The largest difference in units in the last place of the largest expected number.
pub fn last_places(found: &[f64], expected: &[f64], epsilon: f64) -> f64 {
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let largest = found.iter().zip(expected).fold(0.0_f64, |largest, (a, b)| largest.max((a - b).abs()));
    largest / (epsilon * size)
}

/// The prototypes of a header.
fn functions(header: &str, prefix: &str) -> Vec<Function> {
    let mut functions = Vec::new();
    for part in header.split(&format!(" {prefix}_")).skip(1) {
        let Some((name, rest)) = part.split_once('(') else { continue };
        // the step has a test of its own, `c_step`
        if name.contains(char::is_whitespace) || name == "step_rk4" {
            continue;
        }
        let arguments = rest.split_once(')').unwrap().0;
        let mut function =
            Function { name: name.to_owned(), inputs: vec![], outputs: vec![], returns: false };
        for argument in arguments.split(',').map(str::trim).filter(|argument| *argument != "void") {
            let (name, size) = match argument.rsplit_once(' ').unwrap().1.split_once('[') {
                Some((name, size)) => (name, size.trim_end_matches(']').parse().unwrap()),
                None => (argument.rsplit_once('*').unwrap().1, 0),
            };
            let list =
                if argument.starts_with("const") { &mut function.inputs } else { &mut function.outputs };
            list.push((name.to_owned(), size));
        }
        if function.outputs.is_empty() {
            function.returns = true;
            function.outputs.push(("result".to_owned(), 1));
        }
        functions.push(function);
    }
    functions
}

/// A program that reads the bits of all inputs, calls every function and prints the bits of all results.
fn main_program(functions: &[Function], code: &GeneratedC) -> String {
    let scalar = if code.header.contains("float") { "float" } else { "double" };
    let prefix = &code.prefix;
    let mut text = format!(
        "#include \"{prefix}.h\"\n#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n\n\
         static {scalar} next(void) {{\n    uint64_t bits = 0;\n    double value = 0.0;\n    \
         if (scanf(\"%\" SCNx64, &bits) != 1) {{ return 0; }}\n    memcpy(&value, &bits, sizeof value);\n    \
         return ({scalar})value;\n}}\n\n\
         static void show(const {scalar} *values, int count) {{\n    for (int k = 0; k < count; k++) {{\n        \
         const double value = (double)values[k];\n        uint64_t bits = 0;\n        \
         memcpy(&bits, &value, sizeof bits);\n        printf(\"%\" PRIx64 \"\\n\", bits);\n    }}\n}}\n\n\
         int main(void) {{\n"
    );
    for function in functions {
        text.push_str("    {\n");
        for (name, size) in &function.inputs {
            let _ = writeln!(
                text,
                "        {scalar} {name}[{size}];\n        for (int k = 0; k < {size}; k++) {{ {name}[k] = next(); }}"
            );
        }
        let mut arguments: Vec<String> = function.inputs.iter().map(|(name, _)| name.clone()).collect();
        for (name, size) in &function.outputs {
            let _ = writeln!(text, "        {scalar} {name}[{}];", (*size).max(1));
            if !function.returns {
                arguments.push(name.clone());
            }
        }
        let result = if function.returns { "result[0] = " } else { "" };
        let _ = writeln!(text, "        {result}{prefix}_{}({});", function.name, arguments.join(", "));
        for (name, size) in &function.outputs {
            let _ = writeln!(text, "        show({name}, {});", (*size).max(1));
        }
        text.push_str("    }\n");
    }
    text.push_str("    return 0;\n}\n");
    text
}
