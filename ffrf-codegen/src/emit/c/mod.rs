//! The C printer: listings as a header and a source of portable C99.
//!
//! ```text
//! PREFIX.h    counts and numbers of the body, types of markers and of its state, prototypes with documentation
//! PREFIX.c    markers, one function for each kernel, and a step of the free body about them
//! ```
//!
//! No heap, no recursion, no loop but those of fixed length in the step, no global that changes; `sqrt` is all that is taken
//! from the library.

mod declaration;
mod function;
mod markers;
mod mechanism;
mod notation;
mod step;
mod template;
mod text;

pub(crate) use self::mechanism::{MechanismSubject, Names, mechanism};

use self::declaration::Declaration;
use self::notation::Notation;
use self::text::Text;
use super::expression::expression;
use super::listing::{Listing, Tree, listing};
use super::units::UnitNames;
use super::{Subject, banner};
use crate::validate::ValidKernel;
use crate::{GenerateOptions, ScalarType};

/// Header and source of a body.
pub(crate) struct Files {
    /// The header.
    pub(crate) header: String,
    /// The source; it includes `PREFIX.h`.
    pub(crate) source: String,
    /// Header and source in one text.
    pub(crate) single: String,
    /// `PREFIX`.
    pub(crate) prefix: String,
}

/// What the text of one body has in common.
struct Style {
    /// Before every name that other files see, in lower case.
    prefix: String,
    /// The same in upper case.
    macro_prefix: String,
    scalar: ScalarType,
    mode_count: usize,
}

impl Style {
    fn of(options: &GenerateOptions, mode_count: usize) -> Self {
        let prefix = snake_case(&options.name);
        Self { macro_prefix: prefix.to_uppercase(), prefix, scalar: options.scalar, mode_count }
    }

    /// The C name of the scalar type.
    fn type_name(&self) -> &'static str {
        notation::type_name(self.scalar)
    }
}

/// What users of several targets want to know.
const BITS: &str =
    "Compiled without contraction (-ffp-contract=off), it gives the same bits on every target.";

/// Header and source of a body whose numbers are baked in.
pub(super) fn files(subject: &Subject<'_>, kernels: &[ValidKernel]) -> Files {
    let style = Style::of(subject.options, subject.report.mode_count);
    let declarations: Vec<(Listing, Declaration)> = kernels
        .iter()
        .map(|kernel| {
            let plain = Notation::new(&style, None);
            let listing = listing(kernel, |tree: &Tree| expression(tree, &plain).chars().count());
            let declaration = Declaration::of(&listing, &style);
            (listing, declaration)
        })
        // without modes, some have nothing to compute
        .filter(|(_, declaration)| declaration.has_results())
        .collect();
    let header = header(subject, &style, &declarations);
    let definitions = definitions(subject, &style, &declarations);
    Files {
        source: format!("{}#include \"{}.h\"\n\n{definitions}", banner_comment(subject), style.prefix),
        single: format!("{header}\n{definitions}"),
        header,
        prefix: style.prefix,
    }
}

/// One kernel as a function that no other file sees, with its documentation.
pub(crate) fn kernel(kernel: &ValidKernel, options: &GenerateOptions, mode_count: usize) -> String {
    let style = Style::of(options, mode_count);
    let plain = Notation::new(&style, None);
    let listing = listing(kernel, |tree: &Tree| expression(tree, &plain).chars().count());
    let mut declaration = Declaration::of(&listing, &style);
    declaration.is_local = true;
    let mut text = Text::new(UnitNames::of(None));
    text.comment(declaration.documentation(&listing));
    function::function(&mut text, &listing, &declaration, &style);
    text.finish()
}

fn header(subject: &Subject<'_>, style: &Style, declarations: &[(Listing, Declaration)]) -> String {
    let mut text = Text::new(UnitNames::of(subject.model));
    let mut lines = banner_of(subject);
    lines.extend(["".to_owned(), BITS.to_owned()]);
    text.comment(lines);
    let guard = format!("{}_H", style.macro_prefix);
    text.line(format!("#ifndef {guard}\n#define {guard}\n"));
    text.line("#ifdef __cplusplus\nextern \"C\" {\n#endif\n");
    markers::constants(&mut text, subject, style);
    markers::declarations(&mut text, subject, style);
    for (listing, declaration) in declarations {
        text.documentation(declaration.documentation(listing));
        text.line(format!("{};\n", declaration.prototype()));
    }
    step::declaration(&mut text, style);
    text.line("#ifdef __cplusplus\n}\n#endif\n");
    text.line(format!("#endif /* {guard} */"));
    text.finish()
}

fn banner_comment(subject: &Subject<'_>) -> String {
    let mut text = Text::new(UnitNames::of(subject.model));
    text.comment(banner_of(subject));
    text.finish()
}

/// What stands in the source besides its banner and the header.
fn definitions(subject: &Subject<'_>, style: &Style, declarations: &[(Listing, Declaration)]) -> String {
    let mut text = Text::new(UnitNames::of(subject.model));
    // of the step
    text.line("#include <math.h>\n");
    markers::definitions(&mut text, subject, style);
    for (listing, declaration) in declarations {
        function::function(&mut text, listing, declaration, style);
    }
    step::definition(&mut text, style);
    text.finish()
}

fn banner_of(subject: &Subject<'_>) -> Vec<String> {
    banner::banner(subject.options, subject.report, subject.model.map(|model| model.units.as_str()))
}

/// `ConrodBody` as `conrod_body`; what C does not allow in a name becomes an underscore.
pub fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut before = '_';
    for c in name.chars() {
        if c.is_uppercase() && (before.is_lowercase() || before.is_ascii_digit()) {
            snake.push('_');
        }
        snake.push(if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' });
        before = c;
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::snake_case;

    #[test]
    fn names_of_types_become_prefixes() {
        for (name, prefix) in [
            ("ConrodBody", "conrod_body"),
            ("Body", "body"),
            ("HTTPRod", "httprod"),
            ("Rod2Left", "rod2_left"),
            ("already_snake", "already_snake"),
            ("Größe", "gr__e"),
        ] {
            assert_eq!(snake_case(name), prefix);
        }
    }
}
