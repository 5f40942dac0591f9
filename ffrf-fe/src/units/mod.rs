//! Units of a model: conversion, and whether the numbers are those of a solid.

mod conversion;
mod plausibility;
mod volume;

pub use conversion::Conversion;
pub use plausibility::implausible;
