//! Misuse of `flexible_body!` is answered with one message per mistake, at its place.

/// Messages belong to one compiler; others may word or place them differently.
const PINNED: &str = "1.95.0";

#[test]
fn each_mistake_has_its_message() {
    let version = std::process::Command::new("rustc").arg("--version").output();
    let version =
        version.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    if !version.contains(PINNED) {
        eprintln!("SKIPPED: messages are those of rustc {PINNED}, found {version}");
        return;
    }
    // The models that the cases name are copied next to the manifest that the cases are compiled with.
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
