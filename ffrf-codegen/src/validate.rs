//! The validator: the only maker of what the emitter accepts.

use crate::expression::{Expression, Node, Symbol};
use crate::formulate::Kernel;
use crate::{ArrayInput, CodegenError, ScalarType};

/// A kernel whose constants are finite, whose inputs are in its signature, whose nodes refer backwards, and
/// which has as many results as its signature needs.
#[derive(Debug, Clone)]
pub struct ValidKernel(Kernel);

impl ValidKernel {
    /// Checks a kernel for values of type `scalar`; `has_parameters` says whether the invariants are inputs.
    ///
    /// Errors: `OutputCount`, `NotFinite`, `UndefinedSymbol`, `ForwardReference`.
    pub fn new(kernel: Kernel, scalar: ScalarType, has_parameters: bool) -> Result<Self, CodegenError> {
        Self::with_inputs(kernel, scalar, |kernel, symbol| is_input(kernel, symbol, has_parameters))
    }

    /// [`new`](Self::new) of a kernel whose inputs are entries of arrays.
    pub(crate) fn of_arrays(
        kernel: Kernel,
        scalar: ScalarType,
        arrays: &[ArrayInput],
    ) -> Result<Self, CodegenError> {
        Self::with_inputs(kernel, scalar, |_, symbol| match symbol {
            Symbol::Intermediate(entry, index) => {
                arrays.iter().any(|array| array.entry == entry && index < array.count)
            }
            Symbol::Input(..) | Symbol::Parameter(..) => false,
        })
    }

    fn with_inputs(
        kernel: Kernel,
        scalar: ScalarType,
        is_input: impl Fn(&Kernel, Symbol) -> bool,
    ) -> Result<Self, CodegenError> {
        let name = kernel.signature.name;
        let expected = kernel.signature.entries(kernel.mode_count);
        if kernel.outputs.len() != expected {
            return Err(CodegenError::OutputCount { kernel: name, found: kernel.outputs.len(), expected });
        }
        for (handle, node) in kernel.graph.nodes() {
            check_node(&kernel, handle, node, scalar, &is_input)?;
        }
        if let Some(output) = kernel.outputs.iter().find(|output| output.index() >= kernel.graph.len()) {
            let (node, operand) = (kernel.graph.len(), output.index());
            return Err(CodegenError::ForwardReference { kernel: name, node, operand });
        }
        Ok(Self(kernel))
    }

    /// The kernel.
    pub fn kernel(&self) -> &Kernel {
        &self.0
    }
}

fn check_node(
    kernel: &Kernel,
    handle: Expression,
    node: Node,
    scalar: ScalarType,
    is_input: &impl Fn(&Kernel, Symbol) -> bool,
) -> Result<(), CodegenError> {
    let name = kernel.signature.name;
    match node {
        Node::Constant(constant) if !scalar.is_finite(constant.value()) => {
            return Err(CodegenError::NotFinite {
                kernel: name,
                node: handle.index(),
                found: constant.value(),
            });
        }
        Node::Symbol(symbol) if !is_input(kernel, symbol) => {
            return Err(CodegenError::UndefinedSymbol { kernel: name, symbol: symbol.to_string() });
        }
        _ => {}
    }
    match node.operands().find(|operand| *operand >= handle) {
        Some(operand) => Err(CodegenError::ForwardReference {
            kernel: name,
            node: handle.index(),
            operand: operand.index(),
        }),
        None => Ok(()),
    }
}

fn is_input(kernel: &Kernel, symbol: Symbol, has_parameters: bool) -> bool {
    match symbol {
        Symbol::Input(input, k) => {
            kernel.signature.inputs.contains(&input) && k < input.size(kernel.mode_count)
        }
        Symbol::Parameter(..) => has_parameters,
        Symbol::Intermediate(..) => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Graph, Input};
    use crate::formulate::Draft;
    use crate::formulate::kernels::ELASTIC_ENERGY;
    use crate::invariants::Invariant;

    fn energy(build: impl FnOnce(&mut Graph) -> Vec<Expression>) -> Result<ValidKernel, String> {
        let mut graph = Graph::new();
        let outputs = build(&mut graph);
        let graph = Draft::new(graph);
        let kernel = Kernel { signature: ELASTIC_ENERGY.signature, mode_count: 1, graph, outputs };
        ValidKernel::new(kernel, ScalarType::F32, false).map_err(|error| error.to_string())
    }

    #[test]
    fn a_sound_kernel_passes() {
        let kernel = energy(|graph| {
            let q = graph.symbol(Input::COORDINATES.symbol(0));
            vec![graph.multiply(q, q)]
        });
        assert_eq!(kernel.unwrap().kernel().graph.len(), 2);
    }

    #[test]
    fn constants_that_are_not_finite_are_refused() {
        let error = energy(|graph| vec![graph.constant(f64::INFINITY)]).unwrap_err();
        assert_eq!(
            error,
            "elastic_energy: node 0 is the constant inf, expected a number that is finite in the scalar type of the body"
        );
    }

    #[test]
    fn constants_beyond_the_scalar_type_are_refused() {
        assert!(energy(|graph| vec![graph.constant(1e39)]).is_err());
        assert!(energy(|graph| vec![graph.constant(1e38)]).is_ok());
    }

    #[test]
    fn foreign_inputs_are_refused() {
        let error = energy(|graph| vec![graph.symbol(Input::RATES.symbol(0))]).unwrap_err();
        assert_eq!(error, "elastic_energy: q_dot0 is not an input of this kernel");
        assert!(energy(|graph| vec![graph.symbol(Input::COORDINATES.symbol(1))]).is_err());
        assert!(energy(|graph| vec![graph.symbol(Invariant::Mass.at([]))]).is_err());
    }

    #[test]
    fn missing_results_are_refused() {
        let error = energy(|_| vec![]).unwrap_err();
        assert_eq!(error, "elastic_energy: 0 results, expected 1");
    }
}
