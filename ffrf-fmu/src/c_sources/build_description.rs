//! What FMI 3.0 tells of sources.

use crate::description::attribute;

/// `buildDescription.xml` for sources that are compiled together.
pub(super) fn build_description<'a>(identifier: &str, sources: impl Iterator<Item = &'a str>) -> String {
    let sources: String =
        sources.map(|name| format!("      <SourceFile name=\"{}\"/>\n", attribute(name))).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  \
         <BuildConfiguration modelIdentifier=\"{}\" description=\"portable C without other libraries than that of C\">\n    \
         <SourceFileSet language=\"C99\">\n{sources}    </SourceFileSet>\n    \
         <Library name=\"m\" external=\"true\" description=\"square roots\"/>\n  </BuildConfiguration>\n\
         </fmiBuildDescription>\n",
        attribute(identifier)
    )
}
