//! Code of a mechanism, committed: see ffrf-macros/src/mechanism/tests.rs.

#[doc = r" A flexible pendulum."]
#[derive(Debug, Clone, Copy)]
pub struct Pendulum {
    #[doc = "Body `beam`."]
    pub beam: Beam,
    #[doc = r" Gravity. Shape: 3. Units: m/s². Frame: inertial."]
    pub gravity: ::ffrf::nalgebra::Vector3<f64>,
    #[doc = r" How joints are kept while time advances."]
    pub treatment: ::ffrf::mechanism::Treatment<f64>,
    #[doc = r" How redundant rows are dealt with."]
    pub regularisation: ::ffrf::mechanism::Regularisation<f64>,
    connections: [::ffrf::mechanism::Connection<f64>; 1usize],
    markers_of_beam: [::ffrf::Marker<<Beam as ::ffrf::FlexibleBody<f64>>::Modal, f64>; 2usize],
}
#[allow(dead_code, unused_variables, clippy::all, clippy::pedantic)]
impl Pendulum {
    #[doc = r" The joints and drives by their numbers in errors."]
    pub const JOINTS: [&'static str; 1usize] = ["pin"];
    #[doc = r" The bodies by their numbers in errors."]
    pub const BODIES: [&'static str; 1usize] = ["beam"];
    #[doc = r" The mechanism of these bodies."]
    pub fn new(beam: Beam) -> Self {
        use ::ffrf::generated_support::mechanism as support;
        let mut connections = [support::unconnected::<f64>(); 1usize];
        support::connect::<f64>(&mut connections, 0usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Revolute(::ffrf::joints::Revolute),
            first: ::ffrf::mechanism::Attachment::<f64>::on_ground(
                ::ffrf::nalgebra::Vector3::<f64>::zeros(),
                ::ffrf::mechanism::along_axis::<f64>(&::ffrf::generated_support::mechanism::vector3::<f64>(
                    [0f64, 1f64, 0f64],
                )),
            ),
            second: ::ffrf::mechanism::Attachment::<f64>::on_body(
                0usize,
                0usize,
                ::ffrf::mechanism::along_axis::<f64>(&::ffrf::generated_support::mechanism::vector3::<f64>(
                    [0f64, 1f64, 0f64],
                )),
            ),
        });
        Self {
            beam,
            gravity: ::ffrf::generated_support::mechanism::vector3::<f64>([0.0, 0.0, -9.81]),
            treatment: ::ffrf::mechanism::Treatment::projection(),
            regularisation: ::ffrf::mechanism::Regularisation::of_trees(),
            connections,
            markers_of_beam: [Beam::ROOT, Beam::TIP],
        }
    }
    #[doc = r" Every body at rest at the inertial origin, undeformed, its frame parallel to the inertial frame."]
    pub fn at_rest(&self) -> PendulumState {
        PendulumState { beam: ::ffrf::State::at_rest(&self.beam) }
    }
    #[doc = r" The same mechanism with second triads turned so that the orientations of `state` meet the joints."]
    #[doc = r""]
    #[doc = r" Without this, the triads of both ends of a joint are turned in their markers as the axes say."]
    #[must_use]
    pub fn met_in(self, state: &PendulumState) -> Self {
        let connections = {
            let mut rooms = ::ffrf::mechanism::Assembly::<f64>::rooms(&self);
            let ports = ::ffrf::mechanism::Assembly::<f64>::ports(
                &self,
                &mut rooms,
                *state,
                ::core::option::Option::None,
            );
            self.connections.map(|connection| connection.met_in(&ports))
        };
        Self { connections, ..self }
    }
    #[doc = r" The mechanism in motion: in `state`, at time zero."]
    pub fn in_motion(self, state: PendulumState) -> ::ffrf::mechanism::Mechanism<Self, f64> {
        ::ffrf::mechanism::Mechanism::new(self, state)
    }
    #[doc = r" The state that was saved with `to_array`, bit by bit."]
    pub fn state_from_array(&self, numbers: &[f64; { PendulumState::SIZE }]) -> PendulumState {
        let mut state = self.at_rest();
        let mut numbers = numbers.iter().copied();
        for body in ::core::slice::from_mut(&mut state.beam) {
            body.set_numbers(&mut numbers);
        }
        state
    }
}
#[doc = r" The state of each body."]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PendulumState {
    #[doc = "Of body `beam`."]
    pub beam: ::ffrf::State<<Beam as ::ffrf::FlexibleBody<f64>>::Modal, f64>,
}
#[allow(dead_code, clippy::all, clippy::pedantic)]
impl PendulumState {
    #[doc = r" Number of its numbers: 13 and twice the modes of each body."]
    pub const SIZE: usize = ::core::mem::size_of::<PendulumState>() / ::core::mem::size_of::<f64>();
    #[doc = r" Every number of the state, to be saved: body by body as `ffrf::State::numbers` has them."]
    pub fn to_array(&self) -> [f64; { PendulumState::SIZE }] {
        let mut numbers = [::ffrf::generated_support::constant::<f64>(0.0); { PendulumState::SIZE }];
        let mut places = numbers.iter_mut();
        for body in ::core::slice::from_ref(&self.beam) {
            for number in body.numbers() {
                if let ::core::option::Option::Some(place) = places.next() {
                    *place = number;
                }
            }
        }
        numbers
    }
}
#[doc = r" A change of the state of each body."]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PendulumIncrement {
    #[doc = "Of body `beam`."]
    pub beam: ::ffrf::Increment<<Beam as ::ffrf::FlexibleBody<f64>>::Modal, f64>,
}
#[doc = r" Each body in one state, with its forces and the rows of its joints."]
pub struct PendulumPorts<'a> {
    #[doc = "Body `beam`."]
    pub beam: ::ffrf::mechanism::BodyPort<
        'a,
        Beam,
        [::core::option::Option<
            ::ffrf::mechanism::AttachedRows<<Beam as ::ffrf::FlexibleBody<f64>>::Modal, f64>,
        >; 1usize],
        f64,
        (),
    >,
}
#[allow(clippy::all, clippy::pedantic)]
impl ::ffrf::VectorSpace<f64> for PendulumIncrement {
    fn add_scaled(&mut self, factor: f64, other: &Self) {
        for (own, other) in
            ::core::slice::from_mut(&mut self.beam).iter_mut().zip(::core::slice::from_ref(&other.beam))
        {
            own.add_scaled(factor, other);
        }
    }
    fn scale(&mut self, factor: f64) {
        for own in ::core::slice::from_mut(&mut self.beam) {
            own.scale(factor);
        }
    }
    fn dot(&self, other: &Self) -> f64 {
        let mut sum = ::ffrf::generated_support::constant::<f64>(0.0);
        for (own, other) in
            ::core::slice::from_ref(&self.beam).iter().zip(::core::slice::from_ref(&other.beam))
        {
            sum += own.dot(other);
        }
        sum
    }
}
#[allow(dead_code, unused_variables, clippy::all, clippy::pedantic)]
impl Pendulum {
    #[doc = "Position. Shape: 3. Units: m. Frame: inertial."]
    pub fn tip(&self, state: &PendulumState) -> ::ffrf::nalgebra::Vector3<f64> {
        let mut rooms = ::ffrf::mechanism::Assembly::<f64>::rooms(self);
        let ports =
            ::ffrf::mechanism::Assembly::<f64>::ports(self, &mut rooms, *state, ::core::option::Option::None);
        ::ffrf::mechanism::Attachment::<f64>::on_body(
            0usize,
            1usize,
            ::ffrf::nalgebra::UnitQuaternion::<f64>::identity(),
        )
        .motion(&ports)
        .position
    }
    #[doc = "Force of the joint on its second body at `time` (s). Shape: 3. Units: N. Frame: inertial."]
    #[doc = r""]
    #[doc = r" Errors: no accelerations exist in this state."]
    pub fn load(
        &self,
        time: f64,
        state: &PendulumState,
    ) -> ::core::result::Result<::ffrf::nalgebra::Vector3<f64>, ::ffrf::StepError> {
        ::ffrf::mechanism::Constrained(self).evaluate(
            time,
            *state,
            ::core::option::Option::None,
            |ports, storage| {
                let _ = ports;
                let plan = ::ffrf::mechanism::Assembly::<f64>::plan(self);
                ::ffrf::mechanism::reaction(&plan, storage, 0usize).force
            },
        )
    }
}
#[allow(
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    unused_imports,
    unused_qualifications,
    unused_variables,
    unused_mut
)]
const _: () = {
    use ::ffrf::mechanism as places;
    static STEPS: [places::Step; 2usize] = [
        places::Step {
            size: 6usize,
            node: 0usize,
            diagonal: 0usize,
            is_diagonal: false,
            couplings: 0usize,
            targets: 0usize,
        },
        places::Step {
            size: 5usize,
            node: 1usize,
            diagonal: 2usize,
            is_diagonal: false,
            couplings: 1usize,
            targets: 1usize,
        },
    ];
    static COUPLINGS: [places::Coupling; 1usize] =
        [places::Coupling { size: 5usize, node: 1usize, holds_point: false }];
    static TARGETS: [usize; 1usize] = [2usize];
    static BODIES: [places::BodyPlace; 1usize] = [places::BodyPlace { node: 0usize, diagonal: 0usize }];
    static JOINTS: [places::JointPlace; 1usize] = [places::JointPlace {
        rows: 5usize,
        node: 1usize,
        diagonal: 2usize,
        is_support: false,
        ends: [
            ::core::option::Option::None,
            ::core::option::Option::Some(places::EndPlace {
                body: 0usize,
                slot: 0usize,
                block: places::Block { index: 1usize, transposed: false },
            }),
        ],
    }];
    static SHARED: [places::SharedPlace; 0usize] = [];
    static BRANCHES: [places::Branch; 1usize] = [places::Branch {
        body: 0usize,
        joint: ::core::option::Option::Some(0usize),
        is_second: true,
        parent: ::core::option::Option::None,
        freedom: 0usize,
        freedoms: 1usize,
    }];
    #[doc = r" Whether bodies have so few modes that a sweep over them costs less than the equations of all joints."]
    const SWEEPS: bool =
        places::sweeps(&[::core::mem::size_of::<<Beam as ::ffrf::FlexibleBody<f64>>::Modal>()
            / ::core::mem::size_of::<f64>()]);
    use ::ffrf::generated_support::mechanism as support;
    impl ::ffrf::mechanism::Ports<f64> for PendulumPorts<'_> {
        fn port(&self, index: usize) -> ::core::option::Option<&dyn ::ffrf::mechanism::Port<f64>> {
            match index {
                0usize => ::core::option::Option::Some(&self.beam),
                _ => ::core::option::Option::None,
            }
        }
        fn port_mut(
            &mut self,
            index: usize,
        ) -> ::core::option::Option<&mut dyn ::ffrf::mechanism::Port<f64>> {
            match index {
                0usize => ::core::option::Option::Some(&mut self.beam),
                _ => ::core::option::Option::None,
            }
        }
    }
    impl ::ffrf::mechanism::Assembly<f64> for Pendulum {
        type State = PendulumState;
        type Increment = PendulumIncrement;
        type Modes = ();
        type Ports<'a>
            = PendulumPorts<'a>
        where
            Self: 'a;
        type Rooms = (
            ::core::option::Option<
                ::ffrf::mechanism::Room<
                    <Beam as ::ffrf::FlexibleBody<f64>>::Modal,
                    [::core::option::Option<
                        ::ffrf::mechanism::AttachedRows<<Beam as ::ffrf::FlexibleBody<f64>>::Modal, f64>,
                    >; 1usize],
                    f64,
                    (),
                >,
            >,
        );
        fn rooms(&self) -> Self::Rooms {
            (::core::option::Option::None,)
        }
        fn ports<'a>(
            &'a self,
            rooms: &'a mut Self::Rooms,
            state: Self::State,
            implicit: ::core::option::Option<::ffrf::mechanism::ImplicitTerms<'a, Self::Increment, f64>>,
        ) -> Self::Ports<'a> {
            PendulumPorts {
                beam: ::ffrf::mechanism::BodyPort::new(
                    &self.beam,
                    &self.markers_of_beam,
                    state.beam,
                    implicit.map(|terms| ::ffrf::mechanism::ImplicitTerms {
                        gamma_h: terms.gamma_h,
                        subtracted: terms.subtracted.map(|all| &all.beam),
                        chart: terms.chart.map(|all| &all.beam),
                    }),
                    (support::absent(), ()),
                    &mut rooms.0,
                ),
            }
        }
        fn collect(&self, ports: &Self::Ports<'_>, increment: &Self::Increment) -> Self::Increment {
            let mut rates = *increment;
            for (own, other) in
                ::core::slice::from_mut(&mut rates.beam).iter_mut().zip(::core::slice::from_ref(&ports.beam))
            {
                *own = other.rate(own);
            }
            rates
        }
        fn straight_rates(
            &self,
            time: f64,
            state: &Self::State,
            increment: &Self::Increment,
        ) -> ::core::option::Option<Self::Increment> {
            const SIZE: usize = PendulumState::SIZE;
            const ACCELERATIONS: usize = (SIZE - 1usize) / 2;
            const FUNCTION: fn(&[f64; SIZE], &[[f64; 3]; 1usize], &mut [f64; ACCELERATIONS]) -> bool =
                printed::accelerations;
            if let ::ffrf::mechanism::Treatment::Baumgarte { .. } = self.treatment {
                return ::core::option::Option::None;
            }
            let mut numbers: [f64; SIZE] = [0.0; SIZE];
            let mut places = numbers.iter_mut();
            for state in ::core::slice::from_ref(&state.beam) {
                support::put_state(state, &mut places);
            }
            let mut drives: [[f64; 3]; 1usize] = [[0.0; 3]; 1usize];
            let mut accelerations: [f64; ACCELERATIONS] = [0.0; ACCELERATIONS];
            if !FUNCTION(&numbers, &drives, &mut accelerations) {
                return ::core::option::Option::None;
            }
            let mut accelerations = accelerations.iter().copied();
            let mut rates = *increment;
            for (own, state) in
                ::core::slice::from_mut(&mut rates.beam).iter_mut().zip(::core::slice::from_ref(&state.beam))
            {
                *own = support::rate_with(own, state, &mut accelerations);
            }
            ::core::option::Option::Some(rates)
        }
        fn correct(&self, ports: &mut Self::Ports<'_>, level: ::ffrf::mechanism::Level) {
            for port in ::core::slice::from_mut(&mut ports.beam) {
                port.correct(level);
            }
        }
        fn state(&self, ports: Self::Ports<'_>) -> Self::State {
            PendulumState { beam: ports.beam.state }
        }
        fn with_storage<R>(
            &self,
            equations: ::ffrf::mechanism::Equations,
            use_it: impl FnOnce(&mut ::ffrf::mechanism::Storage<'_, f64>) -> R,
        ) -> R {
            match equations {
                places::Equations::Tree => use_it(&mut ::ffrf::mechanism::Storage {
                    blocks: &mut support::absent::<_, 0>(),
                    solution: &mut [[::ffrf::generated_support::constant::<f64>(0.0); 6]; 2usize],
                    right: &mut [[::ffrf::generated_support::constant::<f64>(0.0); 6]; 2usize],
                    shift: &mut [[::ffrf::generated_support::constant::<f64>(0.0); 6]; 0],
                    efforts: &mut [::ffrf::generated_support::constant::<f64>(0.0); 0usize],
                    joints: &mut support::absent::<_, 1usize>(),
                    soft_markers: &mut [[0; 2]; 0usize],
                    limbs: &mut support::absent::<_, { if SWEEPS { 1usize } else { 0 } }>(),
                    freedoms: &mut support::absent::<_, { if SWEEPS { 1usize } else { 0 } }>(),
                }),
                _ => use_it(&mut ::ffrf::mechanism::Storage {
                    blocks: &mut support::absent::<_, 3usize>(),
                    solution: &mut [[::ffrf::generated_support::constant::<f64>(0.0); 6]; 2usize],
                    right: &mut [[::ffrf::generated_support::constant::<f64>(0.0); 6]; 2usize],
                    shift: &mut [[::ffrf::generated_support::constant::<f64>(0.0); 6]; 2usize],
                    efforts: &mut [::ffrf::generated_support::constant::<f64>(0.0); 0usize],
                    joints: &mut support::absent::<_, 1usize>(),
                    soft_markers: &mut [[0; 2]; 0usize],
                    limbs: &mut support::absent::<_, 0>(),
                    freedoms: &mut support::absent::<_, 0>(),
                }),
            }
        }
        fn plan(&self) -> ::ffrf::mechanism::Plan<'_> {
            places::Plan {
                branches: if SWEEPS { BRANCHES.as_slice() } else { &[] },
                ..places::Plan {
                    elimination: places::Elimination {
                        steps: &STEPS,
                        leading: 1usize,
                        couplings: &COUPLINGS,
                        targets: &TARGETS,
                        of_instant: true,
                    },
                    bodies: &BODIES,
                    joints: &JOINTS,
                    shared: &SHARED,
                    modes: &[],
                    modal_ends: &[],
                    modal_pairs: &[],
                    branches: &[],
                }
            }
        }
        fn connections(&self) -> &[::ffrf::mechanism::Connection<f64>] {
            &self.connections
        }
        fn joint_name(&self, joint: usize) -> &'static str {
            match Self::JOINTS.get(joint) {
                ::core::option::Option::Some(name) => name,
                ::core::option::Option::None => "",
            }
        }
        fn drive(&self, joint: usize, time: f64) -> [f64; 3] {
            let none = [::ffrf::generated_support::constant::<f64>(0.0); 3];
            match joint {
                _ => none,
            }
        }
        fn load(&self, time: f64, ports: &mut Self::Ports<'_>) {
            for port in ::core::slice::from_mut(&mut ports.beam) {
                ::ffrf::mechanism::Port::weigh(port, &self.gravity);
            }
        }
        fn energy(&self, state: &Self::State) -> ::ffrf::mechanism::Energy<f64> {
            let mut sum = ::ffrf::mechanism::Energy::none();
            for (own, other) in
                ::core::slice::from_ref(&self.beam).iter().zip(::core::slice::from_ref(&state.beam))
            {
                sum.add_body(own, other, &self.gravity);
            }
            sum
        }
        fn momentum(&self, state: &Self::State) -> ::ffrf::mechanism::Momentum<f64> {
            let mut sum = ::ffrf::mechanism::Momentum::none();
            for (own, other) in
                ::core::slice::from_ref(&self.beam).iter().zip(::core::slice::from_ref(&state.beam))
            {
                sum.add_body(own, other);
            }
            sum
        }
        fn treatment(&self) -> ::ffrf::mechanism::Treatment<f64> {
            self.treatment
        }
        fn regularisation(&self) -> ::ffrf::mechanism::Regularisation<f64> {
            self.regularisation
        }
        fn is_finite(&self, state: &Self::State) -> bool {
            ::core::slice::from_ref(&state.beam).iter().all(::ffrf::State::is_finite)
        }
        fn no_change(&self, state: &Self::State) -> Self::Increment {
            PendulumIncrement { beam: ::ffrf::Increment::zeros(&state.beam.modal_coordinates) }
        }
        fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State {
            let mut state = *origin;
            for (own, other) in ::core::slice::from_mut(&mut state.beam)
                .iter_mut()
                .zip(::core::slice::from_ref(&increment.beam))
            {
                *own = own.retract(other);
            }
            state
        }
        fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment {
            let mut rates = *increment;
            for (own, other) in
                ::core::slice::from_mut(&mut rates.beam).iter_mut().zip(::core::slice::from_ref(&origin.beam))
            {
                *own = own.place_rate(&other.retract(own));
            }
            rates
        }
        fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment {
            let mut increment = *increment;
            for port in ::core::slice::from_mut(&mut increment.beam) {
                *port = port.velocities_only();
            }
            increment
        }
        fn local_error(&self, difference: &Self::Increment) -> ::ffrf::LocalError<f64> {
            let mut error = ::ffrf::LocalError {
                position: ::ffrf::generated_support::constant::<f64>(0.0),
                orientation: ::ffrf::generated_support::constant::<f64>(0.0),
                modal_coordinates: ::ffrf::generated_support::constant::<f64>(0.0),
            };
            for part in ::core::slice::from_ref(&difference.beam) {
                error = error.or(part.local_error());
            }
            error
        }
        fn weighted_error(
            &self,
            state: &Self::State,
            difference: &Self::Increment,
            tolerances: &::ffrf::Tolerances<f64>,
        ) -> f64 {
            let (mut sum, mut count) = (
                ::ffrf::generated_support::constant::<f64>(0.0),
                ::ffrf::generated_support::constant::<f64>(0.0),
            );
            for (state, part) in
                ::core::slice::from_ref(&state.beam).iter().zip(::core::slice::from_ref(&difference.beam))
            {
                let (squares, number) = part.weighted_squares(state, tolerances);
                sum += squares;
                count += number;
            }
            ::ffrf::nalgebra::ComplexField::sqrt(sum / count)
        }
        fn largest_stable_step(&self) -> ::core::option::Option<f64> {
            let mut least: ::core::option::Option<f64> = ::core::option::Option::None;
            for body in ::core::slice::from_ref(&self.beam) {
                if let ::core::option::Option::Some(step) =
                    ::ffrf::FlexibleBody::<f64>::largest_stable_step(body)
                {
                    least = ::core::option::Option::Some(match least {
                        ::core::option::Option::Some(other) if other < step => other,
                        _ => step,
                    });
                }
            }
            least
        }
    }
};
