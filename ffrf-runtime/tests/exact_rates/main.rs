//! Velocities, accelerations and rates in the chart of the integrators are exact derivatives: by dual numbers.

mod chart;
mod markers;
mod motions;
