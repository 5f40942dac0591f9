//! Velocities, accelerations and rates in the chart of the integrators are exact derivatives: by dual numbers.

mod chart;
mod forces;
mod joints;
mod markers;
mod motions;
