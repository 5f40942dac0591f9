//! Times generated bodies: `cargo run --release [rounds]`; tables in Markdown on standard output, see `../kernels.sh`.
#![forbid(unsafe_code)]

use kernels::columns::{ACCELERATIONS, EQUATIONS, States, columns, naive};
use kernels::storage;
use kernels::table::Table;
use kernels::timing::{Column, time};

macro_rules! layouts {
    ($table:ident, $rounds:expr; $($modes:literal $size:literal $general:ident $single:ident $free:ident;)*) => {$({
        let states = States::<$modes, $size, f64>::new();
        let states_single = States::<$modes, $size, f32>::new();
        let naive = Box::new(naive::<$modes, $size>());
        let mut all: Vec<Column<'_>> = Vec::new();
        all.extend(columns("general", &kernels::$general::Body, &states));
        all.extend(columns("free-free", &kernels::$free::Body, &states));
        all.extend(columns("general, f32", &kernels::$single::Body, &states_single));
        all.extend(columns("naive", &*naive, &states));
        let times = time(&mut all, $rounds);
        for (column, time) in all.iter().zip(times) {
            $table.add($modes, &column.name, time);
        }
    })*};
}

macro_rules! strategies {
    ($table:ident, $rounds:expr; $($modes:literal $size:literal $statements:ident $lanes:ident;)*) => {$({
        let states = States::<$modes, $size, f64>::new();
        let mut all: Vec<Column<'_>> = Vec::new();
        all.extend(columns("statements", &kernels::$statements::Body, &states));
        all.extend(columns("lanes", &kernels::$lanes::Body, &states));
        let times = time(&mut all, $rounds);
        for (column, time) in all.iter().zip(times) {
            $table.add($modes, &column.name, time);
        }
    })*};
}

macro_rules! storages {
    ($table:ident, $rounds:expr; $($modes:literal $size:literal $groups:literal $pairs:literal $tiles:literal;)*) => {$({
        let states = States::<$modes, $size, f64>::new();
        let mut all = storage::columns::<$modes, $size, $groups, $pairs, $tiles>(&states);
        let times = time(&mut all, $rounds);
        for (column, time) in all.iter().zip(times) {
            $table.add($modes, &column.name, time);
        }
    })*};
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(200);
    let mut layouts = Table::new("Layouts and scalar types");
    layouts! { layouts, rounds;
        1 7 general_m1 single_m1 free_free_m1;
        2 8 general_m2 single_m2 free_free_m2;
        4 10 general_m4 single_m4 free_free_m4;
        8 14 general_m8 single_m8 free_free_m8;
        16 22 general_m16 single_m16 free_free_m16;
        32 38 general_m32 single_m32 free_free_m32;
        64 70 general_m64 single_m64 free_free_m64;
    }
    for kernel in [EQUATIONS, ACCELERATIONS] {
        let (general, free) = (format!("general {kernel}"), format!("free-free {kernel}"));
        layouts.add_ratio(&format!("free-free / general, {kernel}"), &free, &general);
    }
    let mut strategies = Table::new("The change-over from statements to lanes, which is at 7 modes");
    strategies! { strategies, rounds;
        3 9 statements_m3 lanes_m3;
        4 10 statements_m4 lanes_m4;
        5 11 statements_m5 lanes_m5;
        6 12 statements_m6 lanes_m6;
        7 13 statements_m7 lanes_m7;
        8 14 statements_m8 lanes_m8;
    }
    let mut dense = Table::new("The change-over for bodies with a dense Θ_ff, which is at 7 modes as well");
    strategies! { dense, rounds;
        3 9 statements_dense_m3 lanes_dense_m3;
        4 10 statements_dense_m4 lanes_dense_m4;
        5 11 statements_dense_m5 lanes_dense_m5;
        6 12 statements_dense_m6 lanes_dense_m6;
        8 14 statements_dense_m8 lanes_dense_m8;
        16 22 statements_dense_m16 lanes_dense_m16;
    }
    for kernel in [EQUATIONS, ACCELERATIONS] {
        let (lanes, statements) = (format!("lanes {kernel}"), format!("statements {kernel}"));
        for table in [&mut strategies, &mut dense] {
            table.add_ratio(&format!("lanes / statements, {kernel}"), &lanes, &statements);
        }
    }
    let mut storage = Table::new("Accelerations with all moments stored and with half of them");
    storages! { storage, rounds;
        16 22 4 2 48;
        24 30 6 3 120;
        32 38 8 4 224;
        48 54 12 6 528;
        64 70 16 8 960;
    }
    storage.add_ratio("half / whole", "half", "whole");
    for table in [layouts, strategies, dense, storage] {
        println!("{table}");
    }
}
