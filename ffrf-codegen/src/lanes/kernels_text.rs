//! The kernels over lanes as functions, whatever the loops get their invariants from.

use std::fmt::Write as _;

use super::IN_LANES;
use crate::ScalarType;
use crate::formulate::KernelKind;

/// What the functions of one body have in common.
pub(super) struct KernelText<'a> {
    pub(super) modes: usize,
    pub(super) scalar: ScalarType,
    /// Parameters of every function before the state: `body: &NAME, ` or nothing.
    pub(super) parameters: String,
    /// Statements at the start of every function.
    pub(super) preparation: &'a str,
    /// What the loops are methods of.
    pub(super) loops: &'a str,
    /// Statements that make a variable `state` of q, omega and q_dot.
    pub(super) state: String,
    /// The same of q, at rest.
    pub(super) state_at_rest: String,
    /// The force less what the loops do not know, a reference.
    pub(super) net_force: String,
}

impl KernelText<'_> {
    /// All functions, with the documentation that `document` gives for each.
    pub(super) fn functions(&self, document: impl Fn(KernelKind) -> Vec<String>) -> String {
        let mut text = String::new();
        for kind in IN_LANES {
            text.push('\n');
            for line in document(kind) {
                let _ = writeln!(text, "{}", format!("    /// {line}").trim_end());
            }
            text.push_str(&self.function(kind));
        }
        text
    }

    fn function(&self, kind: KernelKind) -> String {
        let (modes, size, name) = (self.modes, 6 + self.modes, self.scalar.type_name());
        let (coordinates, space, vector) =
            (format!("&[{name}; {modes}]"), format!("&[{name}; 3]"), format!("[{name}; {size}]"));
        let form = Form::of(self.scalar);
        let [q, q_dot, velocity, omega] = ["q", "q_dot", "velocity", "omega"].map(|name| form.input(name));
        let state = format!("q: {coordinates}, omega: {space}, q_dot: {coordinates}");
        let moving = format!("q: {coordinates}, velocity: {space}, omega: {space}, q_dot: {coordinates}");
        let net = &self.net_force;
        let evaluation = if kind == KernelKind::MassMatrix { &self.state_at_rest } else { &self.state };
        let (inputs, result, arguments) = match kind {
            KernelKind::MassMatrix => {
                (format!("q: {coordinates}"), format!("[{vector}; {size}]"), String::new())
            }
            KernelKind::QuadraticVelocity => (state, vector.clone(), String::new()),
            KernelKind::ForwardDynamics => {
                (format!("{state}, force: &{vector}"), vector.clone(), format!(", {q}, {q_dot}, {net}"))
            }
            KernelKind::EquationsOfMotion => (
                format!("{state}, force: &{vector}"),
                format!("([{vector}; {size}], {vector}, {vector})"),
                format!(", {q}, {q_dot}, {net}"),
            ),
            KernelKind::AngularMomentum => (moving, format!("[{name}; 3]"), format!(", {velocity}, {omega}")),
            _ => (moving, name.to_owned(), format!(", {velocity}, {omega}, {q_dot}")),
        };
        let (function, generics, preparation) = (kind.name(), self.scalar.generics(), self.preparation);
        format!(
            "    #[inline]
    fn {function}{generics}(
        {}{},
    ) -> {result} {{
{preparation}{evaluation}        {}
    }}
",
            self.parameters,
            inputs.replace(", ", ",\n        ").replace(",\n        &", ", &"),
            form.result(kind, &format!("{}.{function}(&state{arguments})", self.loops))
        )
    }
}

/// How values get into the loops and out of them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// The scalars of the loops are those of the functions.
    Plain,
    /// Any number type is wrapped on its way in and unwrapped on its way out.
    Wrapped,
}

impl Form {
    pub(super) fn of(scalar: ScalarType) -> Self {
        if scalar == ScalarType::Generic { Self::Wrapped } else { Self::Plain }
    }

    /// The scalar type of the loops.
    pub(super) fn register_scalar(self, name: &str) -> String {
        match self {
            Self::Plain => name.to_owned(),
            Self::Wrapped => format!("support::lanes::Real<{name}>"),
        }
    }

    /// A reference to an array, as an argument of the loops.
    pub(super) fn input(self, reference: &str) -> String {
        match self {
            Self::Plain => reference.to_owned(),
            Self::Wrapped => format!("&support::lanes::reals({reference})"),
        }
    }

    /// What a reference to an array points to, as an argument of the loops.
    pub(super) fn value(self, reference: &str) -> String {
        match self {
            Self::Plain => format!("*{reference}"),
            Self::Wrapped => format!("support::lanes::reals({reference})"),
        }
    }

    pub(super) fn zero(self) -> &'static str {
        match self {
            Self::Plain => "0.0",
            Self::Wrapped => "support::constant(0.0)",
        }
    }

    /// The force less the elastic and damping forces that `internal` calls for.
    pub(super) fn net_force(self, internal: &str) -> String {
        format!("&support::lanes::net_force({}, {})", self.input("force"), self.input(internal))
    }

    /// The result of a kernel from that of the loops.
    fn result(self, kind: KernelKind, call: &str) -> String {
        match (self, kind) {
            (Self::Plain, _) => call.to_owned(),
            (Self::Wrapped, KernelKind::MassMatrix) => format!("{call}.map(support::lanes::numbers)"),
            (Self::Wrapped, KernelKind::EquationsOfMotion) => format!(
                "let (mass_matrix, quadratic_velocity, acceleration) = {call};
        (
            mass_matrix.map(support::lanes::numbers),
            support::lanes::numbers(quadratic_velocity),
            support::lanes::numbers(acceleration),
        )"
            ),
            (Self::Wrapped, KernelKind::KineticEnergy) => format!("{call}.0"),
            (Self::Wrapped, _) => format!("support::lanes::numbers({call})"),
        }
    }
}
