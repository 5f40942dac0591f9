//! What the generator says about a body besides its code.

use ffrf_model::ReducedBody;

use crate::counts::OperationCounts;
use crate::formulate::Kernel;
use crate::layout::Layout;

/// Layout and cost of a generated body.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Number of modes used.
    pub mode_count: usize,
    /// The model, if its numbers are baked in.
    pub source: Option<Source>,
    /// The layout found or declared.
    pub layout: Layout,
    /// How the modes stand in lanes, if the kernels with a product over all pairs of modes are loops.
    pub lanes: Option<String>,
    /// Bytes of the tables that loops over lanes read; zero where all numbers stand in statements.
    pub table_bytes: usize,
    /// Cost of each kernel that is printed as statements, in the order in which they are printed.
    pub kernels: Vec<KernelReport>,
}

/// The model that a body was generated from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The model's title.
    pub title: String,
    /// Number of modes in the model.
    pub mode_count: usize,
    /// Hash of the model's content (FNV-1a, 64 bits, of its canonical JSON text): tells versions apart,
    /// protects against nothing.
    pub fingerprint: u64,
}

/// Cost of one kernel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KernelReport {
    /// Name of the function.
    pub name: &'static str,
    /// Operations of one call.
    pub counts: OperationCounts,
}

impl KernelReport {
    /// Name and cost of a kernel.
    pub(crate) fn of(kernel: &Kernel) -> Self {
        Self { name: kernel.signature.name, counts: OperationCounts::of(kernel) }
    }
}

impl Source {
    /// What there is to say about a model.
    ///
    /// Errors: those of [`ReducedBody::to_json`].
    pub fn of(body: &ReducedBody) -> Result<Self, ffrf_model::ModelError> {
        Ok(Self {
            title: body.title.clone(),
            mode_count: body.mode_count(),
            fingerprint: fnv1a(body.to_json()?.as_bytes()),
        })
    }
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_hash_is_the_published_one() {
        // Test vectors of the FNV reference implementation.
        assert_eq!(super::fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(super::fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(super::fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}
