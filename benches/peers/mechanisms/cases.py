"""What is compared: how long each case runs, and the steps (s) or tolerances of each method on both sides."""

halves = lambda first, count: [first / 2**i for i in range(count)]

CASES = {
    # B5 of the field survey: 50 Hz, five turns. Explicit methods are stable below 6.6e-6 s on the damped supports.
    "rotor": {
        "duration": 0.1,
        "samples": 10,
        "ours": {
            # by the equations, to see what straight-line code gains
            "rk4": halves(6.25e-6, 1),
            "linearly_implicit": halves(1.25e-4, 2),
            "radau5_1e-4": halves(6.25e-4, 1),
            "rk4_straight_line": halves(6.25e-6, 2),
            "dopri5_fixed_straight_line": halves(6.25e-6, 2),
            "dopri5_straight_line": [1e-2, 1e-4, 1e-6, 1e-8],
            "linearly_implicit_straight_line": halves(5e-4, 8),
            "generalised_alpha_straight_line": halves(5e-4, 8),
            "radau5_1e-1_straight_line": halves(2.5e-3, 2),
            "radau5_1e-2_straight_line": halves(1.25e-3, 2),
            "radau5_1e-3_straight_line": halves(1.25e-3, 2),
            "radau5_1e-4_straight_line": halves(1.25e-3, 3),
            "radau5_1e-6_straight_line": halves(6.25e-4, 3),
            "radau7_1e-2_straight_line": halves(1.25e-3, 2),
            "radau7_1e-4_straight_line": halves(1.25e-3, 2),
            "radau7_1e-6_straight_line": halves(6.25e-4, 2),
            "radau7_1e-8_straight_line": halves(6.25e-4, 3),
            "radau7_1e-10_straight_line": halves(3.125e-4, 2),
        },
        "exudyn": {
            "generalised_alpha": halves(5e-4, 7),
            "generalised_alpha_newton_1e-5": halves(5e-4, 6),
            "generalised_alpha_newton_1e-4": halves(5e-4, 5),
            "generalised_alpha_full_newton": halves(5e-4, 5),
            "generalised_alpha_rotation_vector": halves(5e-4, 5),
            "trapezoidal_index2": halves(5e-4, 7),
            "rk4": halves(6.25e-6, 2),
            "rk67": halves(6.25e-6, 2),
            "dopri5": [1e-3, 1e-5],
        },
        "reference": {"ours": ("rk4", 2e-6), "exudyn": ("rk4", 5e-6)},
    },
    # B1: two and a half turns of the crank.
    "slider_crank": {
        "duration": 0.1,
        "samples": 10,
        "ours": {
            "rk4": halves(1e-4, 2),
            "linearly_implicit": halves(1.25e-4, 2),
            "radau5_1e-6": halves(2.5e-4, 1),
            "rk4_straight_line": [1.1e-4, *halves(1e-4, 5)],
            "dopri5_fixed_straight_line": halves(5e-5, 3),
            "dopri5_straight_line": [1e-3, 1e-4, 1e-5, 1e-6, 1e-7],
            "linearly_implicit_straight_line": halves(1e-3, 8),
            "generalised_alpha_straight_line": halves(5e-4, 7),
            "radau5_1e-3_straight_line": halves(1e-3, 4),
            "radau5_1e-6_straight_line": halves(5e-4, 4),
            "radau7_1e-5_straight_line": halves(1e-3, 3),
        },
        "exudyn": {
            "generalised_alpha": halves(5e-4, 8),
            "generalised_alpha_newton_1e-5": halves(5e-4, 6),
            "generalised_alpha_newton_1e-4": halves(5e-4, 5),
            "generalised_alpha_full_newton": halves(5e-4, 5),
            "generalised_alpha_rotation_vector": halves(5e-4, 7),
            "trapezoidal_index2": halves(5e-4, 7),
            "trapezoidal_index2_rotation_vector": halves(5e-4, 5),
        },
        # Exudyn has no method of higher order for joints: extrapolated from this step and half of it
        "reference": {"ours": ("rk4", 5e-6), "exudyn": ("generalised_alpha_tight", 2.5e-6)},
    },
}
