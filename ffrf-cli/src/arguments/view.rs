//! The arguments of `ffrf view`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `ffrf view`.
#[derive(Debug, Args)]
pub struct View {
    /// A reduced body (.ffrf.json), or a motion that `ffrf simulate --animation` wrote (.glb).
    #[arg(value_name = "MODEL|MOTION")]
    pub input: PathBuf,
    /// The surface that `ffrf reduce --surface` wrote; without it a body is drawn as bars between its markers.
    #[arg(long, value_name = "SURFACE.npz")]
    pub surface: Option<PathBuf>,
    /// Write one page for a browser, with everything in it (.html), or the model alone (.glb).
    #[arg(short, long, value_name = "PAGE.html", required_unless_present = "sheet")]
    pub output: Option<PathBuf>,
    /// Draw every mode of a reduced body side by side (.svg), for documents. Needs --surface.
    #[arg(long, value_name = "MODES.svg")]
    pub sheet: Option<PathBuf>,
}
