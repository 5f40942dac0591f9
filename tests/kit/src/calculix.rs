//! CalculiX as a witness, where it is installed.

use std::path::Path;
use std::process::Command;

/// What CalculiX prints into the `.dat` file of a deck, or `None`, said loudly, if there is no `ccx`. `folder`: where it may work.
pub fn results(folder: &Path, deck: &str) -> Option<String> {
    if Command::new("ccx").arg("-v").output().is_err() {
        eprintln!("SKIPPED: no ccx (Debian: calculix-ccx)");
        return None;
    }
    std::fs::write(folder.join("deck.inp"), deck).unwrap();
    let run =
        Command::new("ccx").arg("deck").current_dir(folder).env("OMP_NUM_THREADS", "1").output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
    Some(std::fs::read_to_string(folder.join("deck.dat")).unwrap())
}

/// The column CYCLES/TIME of the table of eigenvalues, of so many modes at least. Units: Hz.
pub fn frequencies(results: &str, count: usize) -> Vec<f64> {
    let rows = results.lines().skip_while(|line| !line.contains("E I G E N V A L U E")).skip(1);
    let numbers = rows.take_while(|line| !line.contains("P A R T I C I P A T I O N")).filter_map(|line| {
        let fields: Vec<f64> = line.split_whitespace().map_while(|field| field.parse().ok()).collect();
        (fields.len() == 5).then(|| fields[3])
    });
    let found: Vec<f64> = numbers.collect();
    assert!(found.len() >= count, "{count} frequencies expected:\n{results}");
    found
}
