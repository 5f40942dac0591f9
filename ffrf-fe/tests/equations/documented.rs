//! The table in `docs/theory` has a row for every number, and the tests that it names exist.

use std::fs;
use std::path::Path;

#[test]
fn every_number_from_65_to_222_is_in_the_table_with_a_test_that_exists() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let table = fs::read_to_string(package.join("../docs/theory/equations.md")).expect("the table");
    let sources: String = ["tests/equations", "tests/motion"]
        .iter()
        .flat_map(|folder| fs::read_dir(package.join(folder)).expect("a folder"))
        .map(|file| file.expect("an entry").path())
        .filter(|path| path.is_file())
        .map(|path| fs::read_to_string(path).expect("a source"))
        .collect();
    for number in (65..=222).filter(|&number| number != 159) {
        let row = table.lines().find(|line| line.starts_with(&format!("| ({number}) |")));
        let row = row.unwrap_or_else(|| panic!("({number}) is missing in the table"));
        let named: Vec<_> = row.split('`').filter(|word| word.starts_with("equation")).collect();
        assert!(!named.is_empty(), "({number}) names no test");
        for name in named {
            assert!(name.contains(&format!("{number:03}")), "{name} does not carry the number {number}");
            assert!(sources.contains(&format!("fn {name}(")), "({number}): there is no test {name}");
        }
    }
}
