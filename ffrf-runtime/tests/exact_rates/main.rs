//! Velocities, accelerations and rates in the chart of the integrators are exact derivatives: by dual numbers.

mod chart;
mod joints;
mod markers;
mod motions;
