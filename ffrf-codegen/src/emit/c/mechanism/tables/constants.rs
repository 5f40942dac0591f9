//! Sizes, kinds and tolerances.

use std::fmt::Write as _;

use super::Numbers;
use crate::ScalarType;
use crate::emit::c::mechanism::MechanismSubject;
use crate::emit::c::notation::square_root_name;

/// Sizes, kinds and tolerances.
pub(in super::super) fn constants(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let (model, plan, prefix) = (subject.model, subject.plan, &subject.names.prefix);
    let single = subject.options.scalar == ScalarType::F32;
    let modes = subject.modes();
    let mut text = format!(
        "typedef {kind} real;\ntypedef {prefix}_body body_state;\ntypedef {prefix}_state mechanism_state;\n\
         typedef {prefix}_inputs mechanism_inputs;\n\n#define square_root {root}\n\n",
        kind = subject.type_name(),
        root = square_root_name(subject.options.scalar),
    );
    let has_parameters = model.composition.is_some();
    let statuses = ["DONE", "NO_MASS", "JOINTS_NOT_MET", "NOT_FINITE", "TOO_FAR"];
    for status in statuses {
        let _ = writeln!(text, "#define {status} {}_{status}", prefix.to_uppercase());
    }
    let refinements = if single { [3, 3] } else { [2, 0] };
    let sizes = [
        ("BODIES", plan.bodies.len()),
        ("MODES", modes),
        ("VELOCITIES", 6 + modes),
        ("INCREMENT", 2 * (6 + modes)),
        ("SIZE", plan.bodies.len() * 2 * (6 + modes)),
        ("JOINTS", model.joints.len()),
        ("LINKS", plan.joints.len()),
        ("NODES", plan.node_count),
        ("BLOCKS", plan.block_count),
        ("STEPS", plan.steps.len()),
        ("LEADING", plan.leading),
        ("ENDS", plan.attached_ends.iter().sum::<usize>().max(1)),
        ("SHARED", plan.shared.len()),
        ("ELEMENTS", model.elements.len()),
        ("ACTUATORS", model.actuators.len()),
        ("SENSORS", model.sensors.len()),
        ("CORRECTIONS", model.corrections),
        ("REFINEMENTS", if subject.has_loops { refinements[0] } else { 0 }),
        ("REFINEMENTS_OF_CORRECTIONS", if subject.has_loops { refinements[1] } else { 0 }),
    ];
    let composed = model.composition.iter().flat_map(|composition| {
        let relations = model.joints.iter().map(|joint| joint.relations.len()).sum();
        [
            ("PARAMETERS", composition.parameters.len()),
            ("RELATIONS", relations),
            ("ASSEMBLING_PASSES", 20),
            ("CORRECTIONS_OF_A_PASS", 2),
            ("CORRECTIONS_OF_LAST_PASS", 8),
        ]
    });
    text.push_str("\n/* Sizes. */\nenum {\n");
    for (name, size) in sizes.into_iter().chain(composed) {
        let _ = writeln!(text, "    {name} = {size},");
    }
    text.truncate(text.len() - 2);
    text.push_str("\n};\n\n/* Kinds of relations, force elements, efforts and sensors. */\n");
    for kinds in [
        "COINCIDENT, IN_PLANE, PERPENDICULAR, ALIGNED, DISTANCE, ANGLE",
        "SPRING, TORSION_SPRING, BUSHING, CONSTANT, FRICTION",
        "ABOUT, ALONG, LINE",
        "POSITION, VELOCITY, ACCELERATION, ORIENTATION, TURN, REACTION_FORCE, REACTION_MOMENT",
    ] {
        let _ = writeln!(text, "enum {{ {kinds} }};");
    }
    if has_parameters {
        text.push_str(
            "\n/* Where parameters go, and what joints and forces take from the initial state. */\n",
        );
        for kinds in [
            "TO_NOTHING, TO_GRAVITY, TO_POSITION, TO_ORIENTATION, TO_VELOCITY, TO_ANGULAR_VELOCITY, TO_COORDINATE, TO_RATE,\n    \
             TO_STIFFNESS, TO_DAMPING, TO_REST_LENGTH, TO_REST_ANGLE, TO_SPEED, TO_WRENCH, TO_GAIN, TO_LIMIT",
            "RULE_NOTHING, RULE_TURNING, RULE_HELD, RULE_AXIS, RULE_LENGTH, RULE_AS",
        ] {
            let _ = writeln!(text, "enum {{ {kinds} }};");
        }
    }
    let round_off = if single { f64::from(f32::EPSILON) } else { f64::EPSILON };
    let share = if single { 1e-3 } else { 1e-9 };
    let (quarter, largest) = if single {
        ([1.5703125, 0.000_483_751_296_997_070_3, 7.549_789_954_891_882e-8], 12_867.0)
    } else {
        ([1.570_796_012_878_418, 3.139_164_164_167_596e-7, 6.223_372_171_896_613e-14], 3.373_259_425e9)
    };
    let constants = [
        ("ROUND_OFF", round_off, "round-off of one"),
        ("SHARE", share, "of the compliance that redundant rows meet: what they are shifted by"),
        ("ENOUGH_REFINED", (round_off / share) * (round_off / share), "refinements end here"),
        ("ENOUGH_PROJECTED", 1e-6, "the share of a step's drift that may stay"),
        (
            "TOLERANCE",
            if single { model.tolerance.max(1e-4) } else { model.tolerance },
            "of joints, m or rad",
        ),
        ("PI", std::f64::consts::PI, "half a turn"),
        ("QUARTER_HIGH", quarter[0], "a quarter turn in three parts"),
        ("QUARTER_MIDDLE", quarter[1], "a quarter turn in three parts"),
        ("QUARTER_LOW", quarter[2], "a quarter turn in three parts"),
        ("LARGEST_ANGLE", largest, "of a driven joint, rad"),
    ];
    let composed = [
        ("ASSEMBLED", if single { 1e-4 } else { 1e-8 }, "of joints at the beginning, m or rad"),
        ("LARGEST", if single { f64::from(f32::MAX) } else { f64::MAX }, "of all numbers"),
    ];
    text.push('\n');
    let composed = composed.into_iter().filter(|_| has_parameters);
    for (name, value, what) in constants.into_iter().chain(composed) {
        let _ = writeln!(text, "#define {name} {} /* {what} */", numbers.one(value));
    }
    text.push('\n');
    text
}
