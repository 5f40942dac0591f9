// What `ffrf plan` prints; made by the test `plan` of ffrf-cli.
ffrf::flexible_body! {
    pub struct Rod {
        model: "models/conrod.ffrf.json",
        modes: ..8,
        fidelity: constant,
    }
}
ffrf::mechanism! {
    pub struct SliderCrank {
        bodies: {
            crank: rigid { mass: 0.5, center_of_mass: [0.01, 0.0, 0.0], inertia: [[0.0002, 0.0, 0.0], [0.0, 0.0004, 0.0], [0.0, 0.0, 0.0005]], markers: { PIN: [0.04, 0.0, 0.0] } },
            rod: Rod,
            piston: rigid { mass: 0.3, inertia: [[0.0001, 0.0, 0.0], [0.0, 0.0001, 0.0], [0.0, 0.0, 0.0001]] },
        },
        gravity: [0.0, 0.0, -9.81],
        joints: {
            main: revolute(ground, crank, axis: [0.0, 0.0, 1.0]),
            big_end: revolute(crank.PIN, rod.BIG_END, axis: [0.0, 0.0, 1.0]),
            small_end: spherical(rod.SMALL_END, piston),
            guide: prismatic(ground, piston, axis: [1.0, 0.0, 0.0]),
        },
        drives: {
            main_drive: angle(main, polynomial: [0.0, 100.0]),
        },
        sensors: {
            stroke: position(piston),
            bearing: reaction_force(main),
            pin: reaction_force(big_end),
        },
    }
}
