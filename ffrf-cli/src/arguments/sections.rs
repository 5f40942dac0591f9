//! Cuts through a part on the command line.

/// `NAME=plane:x,y,z,x,y,z`
#[derive(Debug, Clone, PartialEq)]
pub struct SectionArgument {
    /// What stands before `=`.
    pub name: String,
    /// A point of the plane.
    pub point: [f64; 3],
    /// Its normal.
    pub normal: [f64; 3],
}

pub(super) fn parse_section(text: &str) -> Result<SectionArgument, String> {
    let form = "expected NAME=plane:x,y,z,x,y,z: a point and the normal";
    let (name, plane) = text.split_once('=').ok_or(form)?;
    if !ffrf_model::is_valid_marker_name(name) {
        return Err(format!("`{name}` is no marker name: letters, digits and underscores, a letter first"));
    }
    let numbers = plane.strip_prefix("plane:").ok_or(form)?.split(',').map(|part| {
        let number = part.trim().parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| format!("`{part}`: {form}"))
    });
    let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
    let [a, b, c, x, y, z] = numbers[..] else {
        return Err(format!("{form}, found {} numbers", numbers.len()));
    };
    if [x, y, z] == [0.0; 3] {
        return Err("expected a normal that is not zero".to_owned());
    }
    Ok(SectionArgument { name: name.to_owned(), point: [a, b, c], normal: [x, y, z] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_is_a_point_and_a_normal() {
        let found = parse_section("cut=plane:0.1,0,-2e-3,1,0,0").unwrap();
        assert_eq!(
            (found.name.as_str(), found.point, found.normal),
            ("cut", [0.1, 0.0, -2e-3], [1.0, 0.0, 0.0])
        );
        for (text, part) in [
            ("cut", "expected NAME=plane:"),
            ("1=plane:0,0,0,1,0,0", "`1` is no marker name"),
            ("cut=box:0,0,0,1,0,0", "expected NAME=plane:"),
            ("cut=plane:0,0,0,1,0", "found 5 numbers"),
            ("cut=plane:0,0,0,1,0,x", "`x`: expected"),
            ("cut=plane:0,0,0,1,0,inf", "`inf`: expected"),
            ("cut=plane:0,0,0,0,0,0", "a normal that is not zero"),
        ] {
            let message = parse_section(text).unwrap_err();
            assert!(message.contains(part), "{text}: {message}");
        }
    }
}
