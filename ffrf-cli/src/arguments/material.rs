//! `--material`: what the solids of a mesh are made of.

use ffrf_fe::elements::Material;
use ffrf_fe::import::SolidsMaterial;

/// `RHO,E,NU` or `GROUP=RHO,E,NU`.
pub(super) fn parse(text: &str) -> Result<SolidsMaterial, String> {
    let (group, constants) = match text.rsplit_once('=') {
        Some(("", _)) => return Err("expected the name of a group before `=`".to_owned()),
        Some((group, constants)) => (Some(group.to_owned()), constants),
        None => (None, text),
    };
    let number = |part: &str| part.trim().parse::<f64>().map_err(|error| format!("`{part}`: {error}"));
    match constants.split(',').map(number).collect::<Result<Vec<f64>, _>>()?.as_slice() {
        &[density, youngs_modulus, poisson_ratio] => {
            Ok(SolidsMaterial { group, material: Material { density, youngs_modulus, poisson_ratio } })
        }
        others => Err(format!("expected three numbers, RHO,E,NU, found {}", others.len())),
    }
}
