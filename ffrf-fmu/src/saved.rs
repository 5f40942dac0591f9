//! The state of an FMU, and how it is written as bytes.

/// Everything of an instance that changes.
#[derive(Debug, Clone, PartialEq)]
pub struct Saved {
    /// How far its life has come, as [`Instance`](crate::Instance) counts it.
    pub(crate) phase: f64,
    /// When the simulation begins. Units: s.
    pub(crate) start: f64,
    /// Values of all parameters.
    pub(crate) parameters: Vec<f64>,
    /// Inputs that were set.
    pub(crate) inputs: Vec<Option<f64>>,
    /// The point of the simulation as numbers, if there is one.
    pub(crate) point: Option<Vec<f64>>,
}

/// What serialised states begin with.
const HEAD: &[u8] = b"ffrf-fmu state 1\n";

impl Saved {
    /// As bytes, with the token of the model; no bit of a number is lost.
    pub fn to_bytes(&self, token: &str) -> Vec<u8> {
        let mut numbers = vec![self.phase, self.start];
        numbers.extend(&self.parameters);
        for input in &self.inputs {
            numbers.extend([f64::from(u8::from(input.is_some())), input.unwrap_or(0.0)]);
        }
        // a point is what is left, if anything is
        numbers.extend(self.point.iter().flatten());
        let mut bytes = [HEAD, token.as_bytes()].concat();
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        bytes
    }

    /// From bytes of the same model with that many parameters and inputs; none if they are not its own.
    pub fn from_bytes(bytes: &[u8], token: &str, parameters: usize, inputs: usize) -> Option<Self> {
        let numbers = bytes.strip_prefix(HEAD)?.strip_prefix(token.as_bytes())?;
        let (numbers, []) = numbers.as_chunks::<8>() else { return None };
        let numbers: Vec<f64> = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        let ([phase, start], rest) = numbers.split_first_chunk()?;
        let (parameters, rest) = rest.split_at_checked(parameters)?;
        let (inputs, point) = rest.split_at_checked(2 * inputs)?;
        let inputs = inputs.as_chunks::<2>().0.iter();
        Some(Self {
            phase: *phase,
            start: *start,
            parameters: parameters.to_vec(),
            inputs: inputs.map(|[is_there, input]| (*is_there != 0.0).then_some(*input)).collect(),
            point: (!point.is_empty()).then(|| point.to_vec()),
        })
    }
}
