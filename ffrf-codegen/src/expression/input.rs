//! Inputs of kernels, described by data: a joint or another body has inputs of its own.

/// Names of the three axes.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// How many entries something has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Extent {
    /// x, y, z.
    Axes,
    /// One for each mode: M.
    Modes,
    /// Translation, rotation and modes: N = 6 + M.
    Velocities,
}

impl Extent {
    /// The number of entries.
    pub const fn size(self, mode_count: usize) -> usize {
        match self {
            Self::Axes => 3,
            Self::Modes => mode_count,
            Self::Velocities => 6 + mode_count,
        }
    }
}

/// A part of an input whose entries have one name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Block {
    /// Name of its entries before their axis or number.
    pub name: &'static str,
    /// How many of them. Modes come last in an input.
    pub extent: Extent,
}

/// An input of kernels: a list of numbers.
///
/// Inputs are told apart by their names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Input {
    /// Name of the argument.
    pub name: &'static str,
    /// Its entries.
    pub blocks: &'static [Block],
}

const fn axes(name: &'static str) -> Block {
    Block { name, extent: Extent::Axes }
}

const fn modes(name: &'static str) -> Block {
    Block { name, extent: Extent::Modes }
}

impl Input {
    /// Modal coordinates q. Shape: M.
    pub const COORDINATES: Self = Self { name: "q", blocks: &[modes("q")] };
    /// Velocity v of the frame origin, body-resolved. Shape: 3. Units: m/s.
    pub const VELOCITY: Self = Self { name: "velocity", blocks: &[axes("velocity")] };
    /// Angular velocity ω of the body frame, body-resolved. Shape: 3. Units: rad/s.
    pub const ANGULAR_VELOCITY: Self = Self { name: "omega", blocks: &[axes("omega")] };
    /// Modal rates q̇. Shape: M.
    pub const RATES: Self = Self { name: "q_dot", blocks: &[modes("q_dot")] };
    /// Generalised force: force, moment, modal forces. Shape: N.
    pub const FORCE: Self =
        Self { name: "force", blocks: &[axes("force"), axes("moment"), modes("modal_force")] };
    /// Uniform gravity g, body-resolved. Shape: 3. Units: m/s².
    pub const GRAVITY: Self = Self { name: "gravity", blocks: &[axes("gravity")] };
    /// Accelerations w = [α; ω̇; q̈]. Shape: N.
    pub const ACCELERATION: Self = Self {
        name: "acceleration",
        blocks: &[axes("acceleration"), axes("angular_acceleration"), modes("modal_acceleration")],
    };

    /// Number of entries.
    pub fn size(&self, mode_count: usize) -> usize {
        self.blocks.iter().map(|block| block.extent.size(mode_count)).sum()
    }

    /// Writes the name of entry `k`: that of its block, with an axis or a number.
    pub(super) fn write_entry(&self, f: &mut core::fmt::Formatter<'_>, k: usize) -> core::fmt::Result {
        let mut rest = k;
        for block in self.blocks {
            match block.extent {
                Extent::Axes if rest < 3 => return write!(f, "{}_{}", block.name, AXES[rest]),
                Extent::Axes => rest -= 3,
                Extent::Modes | Extent::Velocities => return write!(f, "{}{rest}", block.name),
            }
        }
        write!(f, "{}{k}", self.name)
    }
}

impl Ord for Input {
    fn cmp(&self, other: &Self) -> core::cmp::Ordering {
        self.name.cmp(other.name)
    }
}

impl PartialOrd for Input {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl core::hash::Hash for Input {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}
