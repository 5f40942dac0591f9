//! Interfaces and component modes on the command line.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use ffrf_fe::component_modes::{ComponentBasis, NodeSelection, ReferenceCondition};

/// Interfaces, and the basis that is made for them.
#[derive(Debug, Args)]
#[command(next_help_heading = "Interfaces and component modes")]
pub struct InterfaceChoice {
    /// Nodes that a joint or a force takes hold of, and how: `set:BORE`, `ids:3,7,9`, `box:x,y,z,x,y,z`,
    /// `cylinder:POINT,AXIS,RADIUS[,TOLERANCE]` or `plane:POINT,NORMAL[,TOLERANCE]`; then `rbe2` (rigid, the
    /// default), `rbe3` (mean) or `rbe3-area` (mean weighted by surface), and `at:x,y,z` for a reference point other
    /// than the mean of the nodes. Becomes a marker NAME. Repeatable.
    #[arg(long = "interface", value_name = "NAME=NODES[,HOW][,at:x,y,z]", value_parser = parse_interface)]
    pub interfaces: Vec<InterfaceArgument>,
    /// Which shapes span the basis; --modes counts its normal modes.
    #[arg(long, value_name = "BASIS", requires = "interfaces", default_value = "craig-bampton")]
    pub basis: BasisArgument,
    /// Keep the shapes as they are in place of orthonormal free-free modes: more expensive to simulate.
    #[arg(long, requires = "interfaces")]
    pub raw: bool,
    /// The frame that deformation is measured in: `mean-axes`, `fixed:NAME` or `chord:NAME,NAME`.
    #[arg(long, value_name = "FRAME", requires = "interfaces", default_value = "mean-axes", value_parser = parse_reference)]
    pub reference: ReferenceCondition,
    /// A load whose static deformation the basis shall hold: nodes as in --interface, then `force:x,y,z`. Repeatable.
    #[arg(long = "static-load", value_name = "NODES,force:x,y,z", requires = "interfaces", value_parser = parse_load, allow_hyphen_values = true)]
    pub static_loads: Vec<LoadArgument>,
    /// Keep transformed modes up to this frequency only.
    #[arg(long, value_name = "HZ", requires = "interfaces", conflicts_with = "raw")]
    pub keep_below: Option<f64>,
    /// Keep transformed modes from this frequency on only.
    #[arg(long, value_name = "HZ", requires = "interfaces", conflicts_with = "raw")]
    pub keep_above: Option<f64>,
    /// Keep transformed modes with at least this share of the static compliance of some interface motion.
    #[arg(long, value_name = "SHARE", requires = "interfaces", conflicts_with = "raw")]
    pub keep_importance: Option<f64>,
    /// Keep at most this many transformed modes, the most important ones.
    #[arg(long, value_name = "N", requires = "interfaces", conflicts_with = "raw")]
    pub keep_count: Option<usize>,
    /// Compare interface transfer functions with the full model up to this frequency.
    #[arg(long, value_name = "HZ", requires = "interfaces")]
    pub transfer_up_to: Option<f64>,
    /// At how many frequencies they are compared.
    #[arg(long, value_name = "COUNT", requires = "transfer_up_to", default_value_t = 40)]
    pub transfer_points: usize,
    /// Compare these bases too, each with as many modes as the body has: names as for --basis, commas between, or `all`.
    #[arg(long, value_name = "BASES", requires = "transfer_up_to", conflicts_with = "raw", value_parser = parse_bases)]
    pub transfer_bases: Option<Bases>,
    /// Plot the comparison.
    #[arg(long, value_name = "OUT.svg", requires = "transfer_up_to")]
    pub transfer_plot: Option<PathBuf>,
}

/// `--transfer-bases`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bases(pub Vec<ComponentBasis>);

/// `--basis`
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BasisArgument {
    /// Constraint modes and normal modes with the interfaces at rest
    CraigBampton,
    /// Attachment modes (inertia relief) and free normal modes
    Attachment,
    /// Free normal modes and their residual flexibility
    Rubin,
    /// Constraint modes, inertia relief, and free normal modes relative to the interfaces
    Herting,
    /// Free normal modes alone
    FreeFree,
    /// Normal modes with the first interface at rest, alone
    Clamped,
}

impl From<BasisArgument> for ComponentBasis {
    fn from(basis: BasisArgument) -> Self {
        match basis {
            BasisArgument::CraigBampton => Self::CraigBampton,
            BasisArgument::Attachment => Self::Attachment,
            BasisArgument::Rubin => Self::Rubin,
            BasisArgument::Herting => Self::Herting,
            BasisArgument::FreeFree => Self::FreeFree,
            BasisArgument::Clamped => Self::Clamped,
        }
    }
}

/// `NAME=NODES[,HOW][,at:x,y,z]`
#[derive(Debug, Clone, PartialEq)]
pub struct InterfaceArgument {
    /// What stands before `=`.
    pub name: String,
    /// Which nodes.
    pub nodes: NodeSelection,
    /// How they are coupled.
    pub coupling: CouplingArgument,
    /// Reference point, if given. Units: m.
    pub reference_point: Option<[f64; 3]>,
}

/// How nodes are coupled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CouplingArgument {
    /// `rbe2`
    Rigid,
    /// `rbe3`
    Mean,
    /// `rbe3-area`
    MeanByArea,
}

/// `NODES,force:x,y,z`
#[derive(Debug, Clone, PartialEq)]
pub struct LoadArgument {
    /// Which nodes.
    pub nodes: NodeSelection,
    /// Force, spread evenly over them. Units: N.
    pub force: [f64; 3],
}

/// `key:value` with the bare numbers that follow it, or a word of its own.
struct Phrase<'a> {
    key: &'a str,
    values: Vec<&'a str>,
}

/// Splits at commas; numbers without a key belong to the phrase before them.
fn phrases(text: &str) -> Vec<Phrase<'_>> {
    let mut phrases: Vec<Phrase<'_>> = Vec::new();
    for part in text.split(',').map(str::trim) {
        match (part.split_once(':'), phrases.last_mut()) {
            (Some((key, value)), _) => phrases.push(Phrase { key: key.trim(), values: vec![value.trim()] }),
            (None, Some(last)) if part.parse::<f64>().is_ok() => last.values.push(part),
            (None, _) => phrases.push(Phrase { key: part, values: Vec::new() }),
        }
    }
    phrases
}

impl Phrase<'_> {
    fn numbers(&self, counts: &[usize], expected: &str) -> Result<Vec<f64>, String> {
        let number = |text: &&str| text.parse::<f64>().ok().filter(|x| x.is_finite());
        let numbers: Option<Vec<f64>> = self.values.iter().map(number).collect();
        numbers.filter(|numbers| counts.contains(&numbers.len())).ok_or_else(|| {
            format!("`{}:{}`: expected {expected} (finite numbers)", self.key, self.values.join(","))
        })
    }

    fn vector(&self) -> Result<[f64; 3], String> {
        let numbers = self.numbers(&[3], "x,y,z")?;
        Ok([numbers[0], numbers[1], numbers[2]])
    }

    /// The nodes, if the phrase names any.
    fn nodes(&self) -> Result<Option<NodeSelection>, String> {
        let three = |numbers: &[f64], first: usize| [numbers[first], numbers[first + 1], numbers[first + 2]];
        Ok(Some(match self.key {
            "set" => NodeSelection::Set(self.values.join(",")),
            "ids" => {
                let ids: Result<Vec<u64>, _> = self.values.iter().map(|value| value.parse()).collect();
                NodeSelection::Ids(
                    ids.map_err(|_| format!("`ids:{}`: expected node ids", self.values.join(",")))?,
                )
            }
            "box" => {
                let numbers = self.numbers(&[6], "two corners x,y,z,x,y,z")?;
                NodeSelection::Box { from: three(&numbers, 0), to: three(&numbers, 3) }
            }
            "cylinder" => {
                let numbers =
                    self.numbers(&[7, 8], "a point x,y,z, an axis x,y,z, a radius and a tolerance")?;
                NodeSelection::Cylinder {
                    point: three(&numbers, 0),
                    axis: three(&numbers, 3),
                    radius: numbers[6],
                    tolerance: numbers.get(7).copied().unwrap_or(0.0),
                }
            }
            "plane" => {
                let numbers = self.numbers(&[6, 7], "a point x,y,z, a normal x,y,z and a tolerance")?;
                NodeSelection::Plane {
                    point: three(&numbers, 0),
                    normal: three(&numbers, 3),
                    tolerance: numbers.get(6).copied().unwrap_or(0.0),
                }
            }
            _ => return Ok(None),
        }))
    }
}

const NODES: &str = "expected nodes: set:, ids:, box:, cylinder: or plane:";

fn parse_interface(text: &str) -> Result<InterfaceArgument, String> {
    let (name, rest) = text.split_once('=').ok_or("expected NAME=NODES")?;
    if !ffrf_model::is_valid_marker_name(name) {
        return Err(format!(
            "`{name}` is no interface name: letters, digits and underscores, a letter first"
        ));
    }
    let (mut nodes, mut coupling, mut reference_point) = (None, CouplingArgument::Rigid, None);
    for phrase in phrases(rest) {
        if let Some(selection) = phrase.nodes()? {
            if nodes.replace(selection).is_some() {
                return Err("expected one choice of nodes, found two".to_owned());
            }
            continue;
        }
        match phrase.key {
            "rbe2" => coupling = CouplingArgument::Rigid,
            "rbe3" => coupling = CouplingArgument::Mean,
            "rbe3-area" => coupling = CouplingArgument::MeanByArea,
            "at" => reference_point = Some(phrase.vector()?),
            other => return Err(format!("`{other}`: {NODES}; rbe2, rbe3 or rbe3-area; at:x,y,z")),
        }
    }
    let nodes = nodes.ok_or(NODES)?;
    Ok(InterfaceArgument { name: name.to_owned(), nodes, coupling, reference_point })
}

fn parse_load(text: &str) -> Result<LoadArgument, String> {
    let (mut nodes, mut force) = (None, None);
    for phrase in phrases(text) {
        match (phrase.nodes()?, phrase.key) {
            (Some(selection), _) => nodes = Some(selection),
            (None, "force") => force = Some(phrase.vector()?),
            (None, other) => return Err(format!("`{other}`: {NODES}; then force:x,y,z")),
        }
    }
    Ok(LoadArgument { nodes: nodes.ok_or(NODES)?, force: force.ok_or("expected force:x,y,z")? })
}

fn parse_reference(text: &str) -> Result<ReferenceCondition, String> {
    match text.split_once(':') {
        None if text == "mean-axes" => Ok(ReferenceCondition::MeanAxes),
        Some(("fixed", interface)) => Ok(ReferenceCondition::Fixed { interface: interface.to_owned() }),
        Some(("chord", names)) => match names.split_once(',') {
            Some((from, to)) => Ok(ReferenceCondition::Chord { from: from.to_owned(), to: to.to_owned() }),
            None => Err("expected two interfaces, chord:NAME,NAME".to_owned()),
        },
        _ => Err(format!("`{text}`: expected mean-axes, fixed:NAME or chord:NAME,NAME")),
    }
}

fn parse_bases(text: &str) -> Result<Bases, String> {
    if text == "all" {
        return Ok(Bases(ComponentBasis::ALL.to_vec()));
    }
    let basis = |name: &str| BasisArgument::from_str(name.trim(), false).map(ComponentBasis::from);
    let bases: Result<Vec<_>, String> = text.split(',').map(basis).collect();
    bases.map(Bases).map_err(|_| {
        let names = BasisArgument::value_variants().iter().filter_map(|basis| basis.to_possible_value());
        let names: Vec<String> = names.map(|value| value.get_name().to_owned()).collect();
        format!("`{text}`: expected `all`, or some of {} with commas between", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interfaces_are_read() {
        let bore = parse_interface("HUB=set:BORE,rbe3-area,at:0,-1.5,2").unwrap();
        assert_eq!(bore.nodes, NodeSelection::Set("BORE".to_owned()));
        assert_eq!(
            (bore.coupling, bore.reference_point),
            (CouplingArgument::MeanByArea, Some([0.0, -1.5, 2.0]))
        );
        let wall = parse_interface("A=cylinder:0,0,0,0,0,1,0.02,1e-4").unwrap();
        assert_eq!(wall.coupling, CouplingArgument::Rigid);
        assert!(matches!(wall.nodes, NodeSelection::Cylinder { radius: 0.02, tolerance: 1e-4, .. }));
        assert_eq!(parse_interface("A=ids:3,7,9,rbe3").unwrap().nodes, NodeSelection::Ids(vec![3, 7, 9]));
        for (text, part) in [
            ("HUB", "NAME=NODES"),
            ("1=set:A", "no interface name"),
            ("A=rbe2", "expected nodes"),
            ("A=set:B,rbe4", "`rbe4`"),
            ("A=box:1,2,3", "two corners"),
            ("A=plane:0,0,0,nan,0,1", "finite numbers"),
            ("A=set:B,set:C", "found two"),
            ("A=ids:3,x", "`x`"),
        ] {
            let message = parse_interface(text).unwrap_err();
            assert!(message.contains(part), "{text}: `{message}` lacks `{part}`");
        }
    }

    #[test]
    fn bases_are_read() {
        let two = parse_bases("free-free, rubin").unwrap();
        assert_eq!(two.0, [ComponentBasis::FreeFree, ComponentBasis::Rubin]);
        assert_eq!(parse_bases("all").unwrap().0.len(), BasisArgument::value_variants().len());
        assert!(parse_bases("rubin,macneal").unwrap_err().contains("craig-bampton"));
    }

    #[test]
    fn loads_and_frames_are_read() {
        let load = parse_load("set:TOP,force:0,0,-1").unwrap();
        assert_eq!(load.force, [0.0, 0.0, -1.0]);
        assert!(parse_load("set:TOP").unwrap_err().contains("force"));
        assert_eq!(
            parse_reference("chord:A,B").unwrap(),
            ReferenceCondition::Chord { from: "A".to_owned(), to: "B".to_owned() }
        );
        assert!(parse_reference("chord:A").unwrap_err().contains("two interfaces"));
    }
}
