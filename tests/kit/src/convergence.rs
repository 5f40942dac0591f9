//! Orders of convergence, measured.

/// Slope of log(error) over log(step) between neighbouring step sizes; the last is the best.
///
/// `error_of` gets the number of steps over the same time; the numbers double each time.
pub fn measured_order(first_steps: usize, doublings: u32, error_of: impl Fn(usize) -> f64) -> f64 {
    let errors: Vec<f64> = (0..=doublings).map(|k| error_of(first_steps << k)).collect();
    let slopes: Vec<f64> = errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
    eprintln!("errors {errors:?}, orders {slopes:.2?}");
    slopes[slopes.len() - 1]
}
