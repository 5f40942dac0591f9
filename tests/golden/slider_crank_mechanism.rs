//! Code of a mechanism, committed: see ffrf-macros/src/mechanism/tests.rs.

#[doc = r" A slider-crank with a flexible rod, in any number type."]
#[derive(Debug, Clone, Copy)]
pub struct SliderCrank<T: ::ffrf::generated_support::Number = f64> {
    #[doc = "Body `crank`."]
    pub crank: ::ffrf::RigidBody<T>,
    #[doc = "Body `rod`."]
    pub rod: Rod,
    #[doc = "Body `piston`."]
    pub piston: Piston,
    #[doc = "Body `links`."]
    pub links: [Rod; 3usize],
    #[doc = r" Gravity. Shape: 3. Units: m/s². Frame: inertial."]
    pub gravity: ::ffrf::nalgebra::Vector3<T>,
    #[doc = "Drive of joint `main`."]
    pub motor: ::ffrf::mechanism::Drive<T>,
    #[doc = "Force `brake`."]
    pub brake: ::ffrf::mechanism::Element<::ffrf::forces::TorsionSpring<T>, T>,
    #[doc = r" How joints are kept while time advances."]
    pub treatment: ::ffrf::mechanism::Treatment<T>,
    #[doc = r" How redundant rows are dealt with."]
    pub regularisation: ::ffrf::mechanism::Regularisation<T>,
    connections: [::ffrf::mechanism::Connection<T>; 8usize],
    markers_of_crank: [::ffrf::Marker<<::ffrf::RigidBody<T> as ::ffrf::FlexibleBody<T>>::Modal, T>; 2usize],
    markers_of_rod: [::ffrf::Marker<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>; 2usize],
    markers_of_piston: [::ffrf::Marker<<Piston as ::ffrf::FlexibleBody<T>>::Modal, T>; 2usize],
    markers_of_links: [::ffrf::Marker<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>; 2usize],
}
const _: () = ::core::assert!(
    ::core::mem::size_of::<<Piston as ::ffrf::FlexibleBody<f64>>::Modal>() == 0,
    "body `piston` is said to be rigid, but its type has modes"
);
#[allow(dead_code, unused_variables, clippy::all, clippy::pedantic)]
impl<T: ::ffrf::generated_support::Number> SliderCrank<T> {
    #[doc = r" The joints and drives by their numbers in errors."]
    pub const JOINTS: [&'static str; 8usize] =
        ["main", "motor", "big_end", "small_end", "guide", "root", "hinges[0]", "hinges[1]"];
    #[doc = r" The bodies by their numbers in errors."]
    pub const BODIES: [&'static str; 6usize] = ["crank", "rod", "piston", "links[0]", "links[1]", "links[2]"];
    #[doc = r" The mechanism of these bodies."]
    pub fn new(rod: Rod, piston: Piston, links: [Rod; 3usize]) -> Self {
        use ::ffrf::generated_support::mechanism as support;
        let mut connections = [support::unconnected::<T>(); 8usize];
        support::connect::<T>(&mut connections, 0usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Revolute(::ffrf::joints::Revolute),
            first: ::ffrf::mechanism::Attachment::<T>::on_ground(
                ::ffrf::nalgebra::Vector3::<T>::zeros(),
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
            second: ::ffrf::mechanism::Attachment::<T>::on_body(
                0usize,
                0usize,
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
        });
        support::connect::<T>(&mut connections, 1usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Angle(::ffrf::joints::Angle),
            first: ::ffrf::mechanism::Attachment::<T>::on_ground(
                ::ffrf::nalgebra::Vector3::<T>::zeros(),
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
            second: ::ffrf::mechanism::Attachment::<T>::on_body(
                0usize,
                0usize,
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
        });
        support::connect::<T>(&mut connections, 2usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Revolute(::ffrf::joints::Revolute),
            first: ::ffrf::mechanism::Attachment::<T>::on_body(
                0usize,
                1usize,
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
            second: ::ffrf::mechanism::Attachment::<T>::on_body(
                1usize,
                0usize,
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
        });
        support::connect::<T>(&mut connections, 3usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Spherical(::ffrf::joints::Spherical),
            first: ::ffrf::mechanism::Attachment::<T>::on_body(
                1usize,
                1usize,
                ::ffrf::nalgebra::UnitQuaternion::<T>::identity(),
            ),
            second: ::ffrf::mechanism::Attachment::<T>::on_body(
                2usize,
                0usize,
                ::ffrf::nalgebra::UnitQuaternion::<T>::identity(),
            ),
        });
        support::connect::<T>(&mut connections, 4usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Prismatic(::ffrf::joints::Prismatic),
            first: ::ffrf::mechanism::Attachment::<T>::on_ground(
                ::ffrf::nalgebra::Vector3::<T>::zeros(),
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    1f64, 0f64, 0f64,
                ])),
            ),
            second: ::ffrf::mechanism::Attachment::<T>::on_body(
                2usize,
                0usize,
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    1f64, 0f64, 0f64,
                ])),
            ),
        });
        support::connect::<T>(&mut connections, 5usize, 1usize, |_| ::ffrf::mechanism::Connection {
            kind: ::ffrf::joints::JointKind::Revolute(::ffrf::joints::Revolute),
            first: ::ffrf::mechanism::Attachment::<T>::on_ground(
                ::ffrf::generated_support::mechanism::vector3::<T>([1.0, 0.0, 0.0]),
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
            second: ::ffrf::mechanism::Attachment::<T>::on_body(
                3usize + (0),
                0usize,
                ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>([
                    0f64, 0f64, 1f64,
                ])),
            ),
        });
        support::connect::<T>(&mut connections, 6usize, 2usize, |number| {
            let i = 0usize + number;
            ::ffrf::mechanism::Connection {
                kind: ::ffrf::joints::JointKind::Universal(::ffrf::joints::Universal),
                first: ::ffrf::mechanism::Attachment::<T>::on_body(
                    3usize + (i),
                    1usize,
                    ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>(
                        [1f64, 0f64, 0f64],
                    )),
                ),
                second: ::ffrf::mechanism::Attachment::<T>::on_body(
                    3usize + (i + 1),
                    0usize,
                    ::ffrf::generated_support::mechanism::crossed(&::ffrf::mechanism::along_axis::<T>(
                        &::ffrf::generated_support::mechanism::vector3::<T>([1f64, 0f64, 0f64]),
                    )),
                ),
            }
        });
        Self {
            crank: ::ffrf::RigidBody::<T>::new(
                ::ffrf::generated_support::constant::<T>(0.5),
                ::ffrf::nalgebra::Vector3::<T>::zeros(),
                ::ffrf::generated_support::mechanism::WrittenInertia::tensor::<T>([2e-4, 4e-4, 5e-4]),
            ),
            rod,
            piston,
            links,
            gravity: ::ffrf::generated_support::mechanism::vector3::<T>([0.0, 0.0, 0.0]),
            motor: ::ffrf::mechanism::Drive::<T>::polynomial(
                &::ffrf::generated_support::mechanism::numbers::<_, T>([0.0, 100.0]),
            ),
            brake: ::ffrf::mechanism::Element {
                kind: ::ffrf::forces::TorsionSpring {
                    stiffness: ::ffrf::generated_support::constant::<T>(0.0),
                    damping: ::ffrf::generated_support::constant::<T>(1e-3),
                    rest_angle: ::ffrf::generated_support::constant::<T>(0.0),
                },
                first: ::ffrf::mechanism::Attachment::<T>::on_body(
                    0usize,
                    1usize,
                    ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>(
                        [0f64, 0f64, 1f64],
                    )),
                ),
                second: ::ffrf::mechanism::Attachment::<T>::on_body(
                    1usize,
                    0usize,
                    ::ffrf::mechanism::along_axis::<T>(&::ffrf::generated_support::mechanism::vector3::<T>(
                        [0f64, 0f64, 1f64],
                    )),
                ),
            },
            treatment: ::ffrf::mechanism::Treatment::projection(),
            regularisation: ::ffrf::mechanism::Regularisation::of_loops(),
            connections,
            markers_of_crank: [
                ::ffrf::Marker::rigid(
                    ::ffrf::generated_support::mechanism::vector3::<T>([0.0, 0.0, 0.0]),
                    &::ffrf::nalgebra::SVector::<T, 0>::zeros(),
                ),
                ::ffrf::Marker::rigid(
                    ::ffrf::generated_support::mechanism::vector3::<T>([0.04, 0.0, 0.0]),
                    &::ffrf::nalgebra::SVector::<T, 0>::zeros(),
                ),
            ],
            markers_of_rod: [Rod::BIG_END.cast::<T>(), Rod::SMALL_END.cast::<T>()],
            markers_of_piston: [
                Piston::PIN.cast::<T>(),
                ::ffrf::Marker::rigid(
                    ::ffrf::generated_support::mechanism::vector3::<T>([0.0, 0.0, 0.0]),
                    &::ffrf::FlexibleBody::<T>::undeformed(&piston),
                ),
            ],
            markers_of_links: [Rod::BIG_END.cast::<T>(), Rod::SMALL_END.cast::<T>()],
        }
    }
    #[doc = r" Every body at rest at the inertial origin, undeformed, its frame parallel to the inertial frame."]
    pub fn at_rest(&self) -> SliderCrankState<T> {
        SliderCrankState {
            crank: ::ffrf::State::at_rest(&self.crank),
            rod: ::ffrf::State::at_rest(&self.rod),
            piston: ::ffrf::State::at_rest(&self.piston),
            links: self.links.each_ref().map(|body| ::ffrf::State::at_rest(body)),
        }
    }
    #[doc = r" The same mechanism with second triads turned so that the orientations of `state` meet the joints."]
    #[doc = r""]
    #[doc = r" Without this, the triads of both ends of a joint are turned in their markers as the axes say."]
    #[must_use]
    pub fn met_in(self, state: &SliderCrankState<T>) -> Self {
        let connections = {
            let mut rooms = ::ffrf::mechanism::Assembly::<T>::rooms(&self);
            let ports = ::ffrf::mechanism::Assembly::<T>::ports(
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
    pub fn in_motion(self, state: SliderCrankState<T>) -> ::ffrf::mechanism::Mechanism<Self, T> {
        ::ffrf::mechanism::Mechanism::new(self, state)
    }
    #[doc = r" The state that was saved with `to_array`, bit by bit."]
    pub fn state_from_array(&self, numbers: &[T; { SliderCrankState::<f64>::SIZE }]) -> SliderCrankState<T> {
        let mut state = self.at_rest();
        let mut numbers = numbers.iter().copied();
        for body in ::core::slice::from_mut(&mut state.crank) {
            body.set_numbers(&mut numbers);
        }
        for body in ::core::slice::from_mut(&mut state.rod) {
            body.set_numbers(&mut numbers);
        }
        for body in ::core::slice::from_mut(&mut state.piston) {
            body.set_numbers(&mut numbers);
        }
        for body in state.links.as_mut_slice() {
            body.set_numbers(&mut numbers);
        }
        state
    }
}
#[doc = r" The state of each body."]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderCrankState<T: ::ffrf::generated_support::Number = f64> {
    #[doc = "Of body `crank`."]
    pub crank: ::ffrf::State<<::ffrf::RigidBody<T> as ::ffrf::FlexibleBody<T>>::Modal, T>,
    #[doc = "Of body `rod`."]
    pub rod: ::ffrf::State<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>,
    #[doc = "Of body `piston`."]
    pub piston: ::ffrf::State<<Piston as ::ffrf::FlexibleBody<T>>::Modal, T>,
    #[doc = "Of body `links`."]
    pub links: [::ffrf::State<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>; 3usize],
}
#[allow(dead_code, clippy::all, clippy::pedantic)]
impl<T: ::ffrf::generated_support::Number> SliderCrankState<T> {
    #[doc = r" Number of its numbers: 13 and twice the modes of each body."]
    pub const SIZE: usize = ::core::mem::size_of::<SliderCrankState<f64>>() / ::core::mem::size_of::<f64>();
    #[doc = r" Every number of the state, to be saved: body by body as `ffrf::State::numbers` has them."]
    pub fn to_array(&self) -> [T; { SliderCrankState::<f64>::SIZE }] {
        let mut numbers = [::ffrf::generated_support::constant::<T>(0.0); { SliderCrankState::<f64>::SIZE }];
        let mut places = numbers.iter_mut();
        for body in ::core::slice::from_ref(&self.crank) {
            for number in body.numbers() {
                if let ::core::option::Option::Some(place) = places.next() {
                    *place = number;
                }
            }
        }
        for body in ::core::slice::from_ref(&self.rod) {
            for number in body.numbers() {
                if let ::core::option::Option::Some(place) = places.next() {
                    *place = number;
                }
            }
        }
        for body in ::core::slice::from_ref(&self.piston) {
            for number in body.numbers() {
                if let ::core::option::Option::Some(place) = places.next() {
                    *place = number;
                }
            }
        }
        for body in self.links.as_slice() {
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
pub struct SliderCrankIncrement<T: ::ffrf::generated_support::Number = f64> {
    #[doc = "Of body `crank`."]
    pub crank: ::ffrf::Increment<<::ffrf::RigidBody<T> as ::ffrf::FlexibleBody<T>>::Modal, T>,
    #[doc = "Of body `rod`."]
    pub rod: ::ffrf::Increment<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>,
    #[doc = "Of body `piston`."]
    pub piston: ::ffrf::Increment<<Piston as ::ffrf::FlexibleBody<T>>::Modal, T>,
    #[doc = "Of body `links`."]
    pub links: [::ffrf::Increment<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>; 3usize],
}
#[doc = r" Each body in one state, with its forces and the rows of its joints."]
pub struct SliderCrankPorts<'a, T: ::ffrf::generated_support::Number = f64> {
    #[doc = "Body `crank`."]
    pub crank: ::ffrf::mechanism::BodyPort<
        'a,
        ::ffrf::RigidBody<T>,
        [::core::option::Option<
            ::ffrf::mechanism::AttachedRows<<::ffrf::RigidBody<T> as ::ffrf::FlexibleBody<T>>::Modal, T>,
        >; 4usize],
        T,
        (),
    >,
    #[doc = "Body `rod`."]
    pub rod: ::ffrf::mechanism::BodyPort<
        'a,
        Rod,
        [::core::option::Option<::ffrf::mechanism::AttachedRows<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>>;
            3usize],
        T,
        (),
    >,
    #[doc = "Body `piston`."]
    pub piston: ::ffrf::mechanism::BodyPort<
        'a,
        Piston,
        [::core::option::Option<
            ::ffrf::mechanism::AttachedRows<<Piston as ::ffrf::FlexibleBody<T>>::Modal, T>,
        >; 2usize],
        T,
        (),
    >,
    #[doc = "Body `links`."]
    pub links: [::ffrf::mechanism::BodyPort<
        'a,
        Rod,
        [::core::option::Option<::ffrf::mechanism::AttachedRows<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>>;
            2usize],
        T,
        (),
    >; 3usize],
}
#[allow(clippy::all, clippy::pedantic)]
impl<T: ::ffrf::generated_support::Number> ::ffrf::VectorSpace<T> for SliderCrankIncrement<T> {
    fn add_scaled(&mut self, factor: T, other: &Self) {
        for (own, other) in
            ::core::slice::from_mut(&mut self.crank).iter_mut().zip(::core::slice::from_ref(&other.crank))
        {
            own.add_scaled(factor, other);
        }
        for (own, other) in
            ::core::slice::from_mut(&mut self.rod).iter_mut().zip(::core::slice::from_ref(&other.rod))
        {
            own.add_scaled(factor, other);
        }
        for (own, other) in
            ::core::slice::from_mut(&mut self.piston).iter_mut().zip(::core::slice::from_ref(&other.piston))
        {
            own.add_scaled(factor, other);
        }
        for (own, other) in self.links.as_mut_slice().iter_mut().zip(other.links.as_slice()) {
            own.add_scaled(factor, other);
        }
    }
    fn scale(&mut self, factor: T) {
        for own in ::core::slice::from_mut(&mut self.crank) {
            own.scale(factor);
        }
        for own in ::core::slice::from_mut(&mut self.rod) {
            own.scale(factor);
        }
        for own in ::core::slice::from_mut(&mut self.piston) {
            own.scale(factor);
        }
        for own in self.links.as_mut_slice() {
            own.scale(factor);
        }
    }
    fn dot(&self, other: &Self) -> T {
        let mut sum = ::ffrf::generated_support::constant::<T>(0.0);
        for (own, other) in
            ::core::slice::from_ref(&self.crank).iter().zip(::core::slice::from_ref(&other.crank))
        {
            sum += own.dot(other);
        }
        for (own, other) in ::core::slice::from_ref(&self.rod).iter().zip(::core::slice::from_ref(&other.rod))
        {
            sum += own.dot(other);
        }
        for (own, other) in
            ::core::slice::from_ref(&self.piston).iter().zip(::core::slice::from_ref(&other.piston))
        {
            sum += own.dot(other);
        }
        for (own, other) in self.links.as_slice().iter().zip(other.links.as_slice()) {
            sum += own.dot(other);
        }
        sum
    }
}
#[allow(dead_code, unused_variables, clippy::all, clippy::pedantic)]
impl<T: ::ffrf::generated_support::Number> SliderCrank<T> {
    #[doc = r" Angle of the joint about its axis, within half a turn. Units: rad."]
    pub fn turn(&self, state: &SliderCrankState<T>) -> T {
        let mut rooms = ::ffrf::mechanism::Assembly::<T>::rooms(self);
        let ports =
            ::ffrf::mechanism::Assembly::<T>::ports(self, &mut rooms, *state, ::core::option::Option::None);
        ::ffrf::forces::relative_angle(
            &self.connections[0usize].first.motion(&ports),
            &self.connections[0usize].second.motion(&ports),
        )
    }
    #[doc = "Moment of the joint on its second body, about the marker there, at `time` (s). Shape: 3. Units: N m. Frame: inertial."]
    #[doc = r""]
    #[doc = r" Errors: no accelerations exist in this state."]
    pub fn bearing(
        &self,
        time: T,
        state: &SliderCrankState<T>,
    ) -> ::core::result::Result<::ffrf::nalgebra::Vector3<T>, ::ffrf::StepError> {
        ::ffrf::mechanism::Constrained(self).evaluate(
            time,
            *state,
            ::core::option::Option::None,
            |ports, storage| {
                let _ = ports;
                let plan = ::ffrf::mechanism::Assembly::<T>::plan(self);
                ::ffrf::mechanism::reaction(&plan, storage, 0usize).moment
                    + ::ffrf::mechanism::reaction(&plan, storage, 1usize).moment
            },
        )
    }
    #[doc = r" Acceleration at `time` (s). Shape: 3. Units: m/s². Frame: inertial."]
    #[doc = r""]
    #[doc = r" Errors: no accelerations exist in this state."]
    pub fn shock(
        &self,
        time: T,
        state: &SliderCrankState<T>,
    ) -> ::core::result::Result<::ffrf::nalgebra::Vector3<T>, ::ffrf::StepError> {
        ::ffrf::mechanism::Constrained(self).evaluate(
            time,
            *state,
            ::core::option::Option::None,
            |ports, storage| {
                let _ = storage;
                ::ffrf::mechanism::acceleration(
                    &::ffrf::mechanism::Attachment::<T>::on_body(
                        2usize,
                        1usize,
                        ::ffrf::nalgebra::UnitQuaternion::<T>::identity(),
                    ),
                    ports,
                )
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
    static STEPS: [places::Step; 14usize] = [
        places::Step {
            size: 6usize,
            node: 0usize,
            diagonal: 0usize,
            is_diagonal: true,
            couplings: 0usize,
            targets: 0usize,
        },
        places::Step {
            size: 6usize,
            node: 1usize,
            diagonal: 4usize,
            is_diagonal: false,
            couplings: 3usize,
            targets: 6usize,
        },
        places::Step {
            size: 6usize,
            node: 2usize,
            diagonal: 7usize,
            is_diagonal: true,
            couplings: 5usize,
            targets: 9usize,
        },
        places::Step {
            size: 6usize,
            node: 3usize,
            diagonal: 10usize,
            is_diagonal: false,
            couplings: 7usize,
            targets: 12usize,
        },
        places::Step {
            size: 6usize,
            node: 4usize,
            diagonal: 13usize,
            is_diagonal: false,
            couplings: 9usize,
            targets: 15usize,
        },
        places::Step {
            size: 6usize,
            node: 5usize,
            diagonal: 16usize,
            is_diagonal: false,
            couplings: 11usize,
            targets: 18usize,
        },
        places::Step {
            size: 1usize,
            node: 7usize,
            diagonal: 18usize,
            is_diagonal: false,
            couplings: 12usize,
            targets: 19usize,
        },
        places::Step {
            size: 4usize,
            node: 13usize,
            diagonal: 21usize,
            is_diagonal: false,
            couplings: 14usize,
            targets: 22usize,
        },
        places::Step {
            size: 5usize,
            node: 10usize,
            diagonal: 23usize,
            is_diagonal: false,
            couplings: 15usize,
            targets: 23usize,
        },
        places::Step {
            size: 3usize,
            node: 9usize,
            diagonal: 25usize,
            is_diagonal: false,
            couplings: 16usize,
            targets: 24usize,
        },
        places::Step {
            size: 4usize,
            node: 12usize,
            diagonal: 27usize,
            is_diagonal: false,
            couplings: 17usize,
            targets: 25usize,
        },
        places::Step {
            size: 5usize,
            node: 11usize,
            diagonal: 29usize,
            is_diagonal: false,
            couplings: 18usize,
            targets: 26usize,
        },
        places::Step {
            size: 5usize,
            node: 6usize,
            diagonal: 30usize,
            is_diagonal: false,
            couplings: 18usize,
            targets: 26usize,
        },
        places::Step {
            size: 5usize,
            node: 8usize,
            diagonal: 32usize,
            is_diagonal: false,
            couplings: 19usize,
            targets: 27usize,
        },
    ];
    static COUPLINGS: [places::Coupling; 19usize] = [
        places::Coupling { size: 1usize, node: 7usize, holds_point: false },
        places::Coupling { size: 5usize, node: 6usize, holds_point: true },
        places::Coupling { size: 5usize, node: 8usize, holds_point: true },
        places::Coupling { size: 3usize, node: 9usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 5usize, node: 10usize, holds_point: false },
        places::Coupling { size: 3usize, node: 9usize, holds_point: true },
        places::Coupling { size: 4usize, node: 12usize, holds_point: false },
        places::Coupling { size: 5usize, node: 11usize, holds_point: false },
        places::Coupling { size: 4usize, node: 13usize, holds_point: false },
        places::Coupling { size: 4usize, node: 12usize, holds_point: false },
        places::Coupling { size: 4usize, node: 13usize, holds_point: false },
        places::Coupling { size: 5usize, node: 6usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 4usize, node: 12usize, holds_point: false },
        places::Coupling { size: 3usize, node: 9usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 5usize, node: 11usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
    ];
    static TARGETS: [usize; 27usize] = [
        18usize, 19usize, 30usize, 20usize, 31usize, 32usize, 25usize, 26usize, 32usize, 23usize, 24usize,
        25usize, 27usize, 28usize, 29usize, 21usize, 22usize, 27usize, 21usize, 30usize, 31usize, 32usize,
        27usize, 25usize, 32usize, 29usize, 32usize,
    ];
    static BODIES: [places::BodyPlace; 6usize] = [
        places::BodyPlace { node: 0usize, diagonal: 0usize },
        places::BodyPlace { node: 1usize, diagonal: 4usize },
        places::BodyPlace { node: 2usize, diagonal: 7usize },
        places::BodyPlace { node: 3usize, diagonal: 10usize },
        places::BodyPlace { node: 4usize, diagonal: 13usize },
        places::BodyPlace { node: 5usize, diagonal: 16usize },
    ];
    static JOINTS: [places::JointPlace; 8usize] = [
        places::JointPlace {
            rows: 5usize,
            node: 6usize,
            diagonal: 30usize,
            is_support: true,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 0usize,
                    block: places::Block { index: 2usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 1usize,
            node: 7usize,
            diagonal: 18usize,
            is_support: false,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 1usize,
                    block: places::Block { index: 1usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 5usize,
            node: 8usize,
            diagonal: 32usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 2usize,
                    block: places::Block { index: 3usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 1usize,
                    slot: 0usize,
                    block: places::Block { index: 6usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 3usize,
            node: 9usize,
            diagonal: 25usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 1usize,
                    slot: 1usize,
                    block: places::Block { index: 5usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 2usize,
                    slot: 0usize,
                    block: places::Block { index: 9usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 5usize,
            node: 10usize,
            diagonal: 23usize,
            is_support: true,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 2usize,
                    slot: 1usize,
                    block: places::Block { index: 8usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 5usize,
            node: 11usize,
            diagonal: 29usize,
            is_support: false,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 3usize,
                    slot: 0usize,
                    block: places::Block { index: 12usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 4usize,
            node: 12usize,
            diagonal: 27usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 3usize,
                    slot: 1usize,
                    block: places::Block { index: 11usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 4usize,
                    slot: 0usize,
                    block: places::Block { index: 15usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 4usize,
            node: 13usize,
            diagonal: 21usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 4usize,
                    slot: 1usize,
                    block: places::Block { index: 14usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 5usize,
                    slot: 0usize,
                    block: places::Block { index: 17usize, transposed: false },
                }),
            ],
        },
    ];
    static SHARED: [places::SharedPlace; 3usize] = [
        places::SharedPlace {
            body: 1usize,
            first: 1usize,
            second: 0usize,
            block: places::Block { index: 26usize, transposed: true },
        },
        places::SharedPlace {
            body: 3usize,
            first: 1usize,
            second: 0usize,
            block: places::Block { index: 28usize, transposed: true },
        },
        places::SharedPlace {
            body: 4usize,
            first: 1usize,
            second: 0usize,
            block: places::Block { index: 22usize, transposed: true },
        },
    ];
    static SOFT_STEPS: [places::Step; 15usize] = [
        places::Step {
            size: 6usize,
            node: 0usize,
            diagonal: 0usize,
            is_diagonal: true,
            couplings: 0usize,
            targets: 0usize,
        },
        places::Step {
            size: 6usize,
            node: 1usize,
            diagonal: 5usize,
            is_diagonal: false,
            couplings: 4usize,
            targets: 10usize,
        },
        places::Step {
            size: 6usize,
            node: 2usize,
            diagonal: 9usize,
            is_diagonal: true,
            couplings: 7usize,
            targets: 16usize,
        },
        places::Step {
            size: 6usize,
            node: 3usize,
            diagonal: 12usize,
            is_diagonal: false,
            couplings: 9usize,
            targets: 19usize,
        },
        places::Step {
            size: 6usize,
            node: 4usize,
            diagonal: 15usize,
            is_diagonal: false,
            couplings: 11usize,
            targets: 22usize,
        },
        places::Step {
            size: 6usize,
            node: 5usize,
            diagonal: 18usize,
            is_diagonal: false,
            couplings: 13usize,
            targets: 25usize,
        },
        places::Step {
            size: 1usize,
            node: 7usize,
            diagonal: 20usize,
            is_diagonal: false,
            couplings: 14usize,
            targets: 26usize,
        },
        places::Step {
            size: 4usize,
            node: 13usize,
            diagonal: 24usize,
            is_diagonal: false,
            couplings: 17usize,
            targets: 32usize,
        },
        places::Step {
            size: 5usize,
            node: 10usize,
            diagonal: 26usize,
            is_diagonal: false,
            couplings: 18usize,
            targets: 33usize,
        },
        places::Step {
            size: 3usize,
            node: 9usize,
            diagonal: 28usize,
            is_diagonal: false,
            couplings: 19usize,
            targets: 34usize,
        },
        places::Step {
            size: 1usize,
            node: 14usize,
            diagonal: 31usize,
            is_diagonal: false,
            couplings: 21usize,
            targets: 37usize,
        },
        places::Step {
            size: 4usize,
            node: 12usize,
            diagonal: 34usize,
            is_diagonal: false,
            couplings: 23usize,
            targets: 40usize,
        },
        places::Step {
            size: 5usize,
            node: 11usize,
            diagonal: 36usize,
            is_diagonal: false,
            couplings: 24usize,
            targets: 41usize,
        },
        places::Step {
            size: 5usize,
            node: 6usize,
            diagonal: 37usize,
            is_diagonal: false,
            couplings: 24usize,
            targets: 41usize,
        },
        places::Step {
            size: 5usize,
            node: 8usize,
            diagonal: 39usize,
            is_diagonal: false,
            couplings: 25usize,
            targets: 42usize,
        },
    ];
    static SOFT_COUPLINGS: [places::Coupling; 25usize] = [
        places::Coupling { size: 1usize, node: 7usize, holds_point: false },
        places::Coupling { size: 1usize, node: 14usize, holds_point: false },
        places::Coupling { size: 5usize, node: 6usize, holds_point: true },
        places::Coupling { size: 5usize, node: 8usize, holds_point: true },
        places::Coupling { size: 3usize, node: 9usize, holds_point: false },
        places::Coupling { size: 1usize, node: 14usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 5usize, node: 10usize, holds_point: false },
        places::Coupling { size: 3usize, node: 9usize, holds_point: true },
        places::Coupling { size: 4usize, node: 12usize, holds_point: false },
        places::Coupling { size: 5usize, node: 11usize, holds_point: false },
        places::Coupling { size: 4usize, node: 13usize, holds_point: false },
        places::Coupling { size: 4usize, node: 12usize, holds_point: false },
        places::Coupling { size: 4usize, node: 13usize, holds_point: false },
        places::Coupling { size: 1usize, node: 14usize, holds_point: false },
        places::Coupling { size: 5usize, node: 6usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 4usize, node: 12usize, holds_point: false },
        places::Coupling { size: 3usize, node: 9usize, holds_point: false },
        places::Coupling { size: 1usize, node: 14usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 5usize, node: 6usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
        places::Coupling { size: 5usize, node: 11usize, holds_point: false },
        places::Coupling { size: 5usize, node: 8usize, holds_point: false },
    ];
    static SOFT_TARGETS: [usize; 42usize] = [
        20usize, 21usize, 31usize, 22usize, 32usize, 37usize, 23usize, 33usize, 38usize, 39usize, 28usize,
        29usize, 31usize, 30usize, 33usize, 39usize, 26usize, 27usize, 28usize, 34usize, 35usize, 36usize,
        24usize, 25usize, 34usize, 24usize, 31usize, 32usize, 37usize, 33usize, 38usize, 39usize, 34usize,
        28usize, 31usize, 33usize, 39usize, 37usize, 38usize, 39usize, 36usize, 39usize,
    ];
    static SOFT_BODIES: [places::BodyPlace; 6usize] = [
        places::BodyPlace { node: 0usize, diagonal: 0usize },
        places::BodyPlace { node: 1usize, diagonal: 5usize },
        places::BodyPlace { node: 2usize, diagonal: 9usize },
        places::BodyPlace { node: 3usize, diagonal: 12usize },
        places::BodyPlace { node: 4usize, diagonal: 15usize },
        places::BodyPlace { node: 5usize, diagonal: 18usize },
    ];
    static SOFT_JOINTS: [places::JointPlace; 9usize] = [
        places::JointPlace {
            rows: 5usize,
            node: 6usize,
            diagonal: 37usize,
            is_support: true,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 0usize,
                    block: places::Block { index: 3usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 1usize,
            node: 7usize,
            diagonal: 20usize,
            is_support: false,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 1usize,
                    block: places::Block { index: 1usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 5usize,
            node: 8usize,
            diagonal: 39usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 2usize,
                    block: places::Block { index: 4usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 1usize,
                    slot: 0usize,
                    block: places::Block { index: 8usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 3usize,
            node: 9usize,
            diagonal: 28usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 1usize,
                    slot: 1usize,
                    block: places::Block { index: 6usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 2usize,
                    slot: 0usize,
                    block: places::Block { index: 11usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 5usize,
            node: 10usize,
            diagonal: 26usize,
            is_support: true,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 2usize,
                    slot: 1usize,
                    block: places::Block { index: 10usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 5usize,
            node: 11usize,
            diagonal: 36usize,
            is_support: false,
            ends: [
                ::core::option::Option::None,
                ::core::option::Option::Some(places::EndPlace {
                    body: 3usize,
                    slot: 0usize,
                    block: places::Block { index: 14usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 4usize,
            node: 12usize,
            diagonal: 34usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 3usize,
                    slot: 1usize,
                    block: places::Block { index: 13usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 4usize,
                    slot: 0usize,
                    block: places::Block { index: 17usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 4usize,
            node: 13usize,
            diagonal: 24usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 4usize,
                    slot: 1usize,
                    block: places::Block { index: 16usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 5usize,
                    slot: 0usize,
                    block: places::Block { index: 19usize, transposed: false },
                }),
            ],
        },
        places::JointPlace {
            rows: 1usize,
            node: 14usize,
            diagonal: 31usize,
            is_support: false,
            ends: [
                ::core::option::Option::Some(places::EndPlace {
                    body: 0usize,
                    slot: 3usize,
                    block: places::Block { index: 2usize, transposed: false },
                }),
                ::core::option::Option::Some(places::EndPlace {
                    body: 1usize,
                    slot: 2usize,
                    block: places::Block { index: 7usize, transposed: false },
                }),
            ],
        },
    ];
    static SOFT_SHARED: [places::SharedPlace; 5usize] = [
        places::SharedPlace {
            body: 1usize,
            first: 1usize,
            second: 0usize,
            block: places::Block { index: 30usize, transposed: true },
        },
        places::SharedPlace {
            body: 3usize,
            first: 1usize,
            second: 0usize,
            block: places::Block { index: 35usize, transposed: true },
        },
        places::SharedPlace {
            body: 4usize,
            first: 1usize,
            second: 0usize,
            block: places::Block { index: 25usize, transposed: true },
        },
        places::SharedPlace {
            body: 1usize,
            first: 2usize,
            second: 0usize,
            block: places::Block { index: 33usize, transposed: true },
        },
        places::SharedPlace {
            body: 1usize,
            first: 2usize,
            second: 1usize,
            block: places::Block { index: 29usize, transposed: false },
        },
    ];
    fn soft_plan() -> places::Plan<'static> {
        places::Plan {
            elimination: places::Elimination {
                steps: &SOFT_STEPS,
                leading: 6usize,
                couplings: &SOFT_COUPLINGS,
                targets: &SOFT_TARGETS,
                of_instant: true,
            },
            bodies: &SOFT_BODIES,
            joints: &SOFT_JOINTS,
            shared: &SOFT_SHARED,
            modes: &[],
            modal_ends: &[],
            modal_pairs: &[],
            branches: &[],
        }
    }
    use ::ffrf::generated_support::mechanism as support;
    impl<T: ::ffrf::generated_support::Number> ::ffrf::mechanism::Ports<T> for SliderCrankPorts<'_, T> {
        fn port(&self, index: usize) -> ::core::option::Option<&dyn ::ffrf::mechanism::Port<T>> {
            match index {
                0usize => ::core::option::Option::Some(&self.crank),
                1usize => ::core::option::Option::Some(&self.rod),
                2usize => ::core::option::Option::Some(&self.piston),
                3usize..=5usize => match self.links.get(index - 3usize) {
                    ::core::option::Option::Some(port) => {
                        ::core::option::Option::Some(port as &dyn ::ffrf::mechanism::Port<T>)
                    }
                    ::core::option::Option::None => ::core::option::Option::None,
                },
                _ => ::core::option::Option::None,
            }
        }
        fn port_mut(&mut self, index: usize) -> ::core::option::Option<&mut dyn ::ffrf::mechanism::Port<T>> {
            match index {
                0usize => ::core::option::Option::Some(&mut self.crank),
                1usize => ::core::option::Option::Some(&mut self.rod),
                2usize => ::core::option::Option::Some(&mut self.piston),
                3usize..=5usize => match self.links.get_mut(index - 3usize) {
                    ::core::option::Option::Some(port) => {
                        ::core::option::Option::Some(port as &mut dyn ::ffrf::mechanism::Port<T>)
                    }
                    ::core::option::Option::None => ::core::option::Option::None,
                },
                _ => ::core::option::Option::None,
            }
        }
    }
    impl<T: ::ffrf::generated_support::Number> ::ffrf::mechanism::Assembly<T> for SliderCrank<T> {
        type State = SliderCrankState<T>;
        type Increment = SliderCrankIncrement<T>;
        type Modes = ();
        type Ports<'a>
            = SliderCrankPorts<'a, T>
        where
            Self: 'a;
        type Rooms = (
            ::core::option::Option<
                ::ffrf::mechanism::Room<
                    <::ffrf::RigidBody<T> as ::ffrf::FlexibleBody<T>>::Modal,
                    [::core::option::Option<
                        ::ffrf::mechanism::AttachedRows<
                            <::ffrf::RigidBody<T> as ::ffrf::FlexibleBody<T>>::Modal,
                            T,
                        >,
                    >; 4usize],
                    T,
                    (),
                >,
            >,
            ::core::option::Option<
                ::ffrf::mechanism::Room<
                    <Rod as ::ffrf::FlexibleBody<T>>::Modal,
                    [::core::option::Option<
                        ::ffrf::mechanism::AttachedRows<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>,
                    >; 3usize],
                    T,
                    (),
                >,
            >,
            ::core::option::Option<
                ::ffrf::mechanism::Room<
                    <Piston as ::ffrf::FlexibleBody<T>>::Modal,
                    [::core::option::Option<
                        ::ffrf::mechanism::AttachedRows<<Piston as ::ffrf::FlexibleBody<T>>::Modal, T>,
                    >; 2usize],
                    T,
                    (),
                >,
            >,
            [::core::option::Option<
                ::ffrf::mechanism::Room<
                    <Rod as ::ffrf::FlexibleBody<T>>::Modal,
                    [::core::option::Option<
                        ::ffrf::mechanism::AttachedRows<<Rod as ::ffrf::FlexibleBody<T>>::Modal, T>,
                    >; 2usize],
                    T,
                    (),
                >,
            >; 3usize],
        );
        fn rooms(&self) -> Self::Rooms {
            (
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                support::absent(),
            )
        }
        fn ports<'a>(
            &'a self,
            rooms: &'a mut Self::Rooms,
            state: Self::State,
            implicit: ::core::option::Option<::ffrf::mechanism::ImplicitTerms<'a, Self::Increment, T>>,
        ) -> Self::Ports<'a> {
            SliderCrankPorts {
                crank: ::ffrf::mechanism::BodyPort::new(
                    &self.crank,
                    &self.markers_of_crank,
                    state.crank,
                    implicit.map(|terms| ::ffrf::mechanism::ImplicitTerms {
                        gamma_h: terms.gamma_h,
                        subtracted: terms.subtracted.map(|all| &all.crank),
                        chart: terms.chart.map(|all| &all.crank),
                    }),
                    (support::absent(), ()),
                    &mut rooms.0,
                ),
                rod: ::ffrf::mechanism::BodyPort::new(
                    &self.rod,
                    &self.markers_of_rod,
                    state.rod,
                    implicit.map(|terms| ::ffrf::mechanism::ImplicitTerms {
                        gamma_h: terms.gamma_h,
                        subtracted: terms.subtracted.map(|all| &all.rod),
                        chart: terms.chart.map(|all| &all.rod),
                    }),
                    (support::absent(), ()),
                    &mut rooms.1,
                ),
                piston: ::ffrf::mechanism::BodyPort::new(
                    &self.piston,
                    &self.markers_of_piston,
                    state.piston,
                    implicit.map(|terms| ::ffrf::mechanism::ImplicitTerms {
                        gamma_h: terms.gamma_h,
                        subtracted: terms.subtracted.map(|all| &all.piston),
                        chart: terms.chart.map(|all| &all.piston),
                    }),
                    (support::absent(), ()),
                    &mut rooms.2,
                ),
                links: {
                    let mut states = state.links.iter();
                    let all = implicit.and_then(|terms| terms.subtracted);
                    let mut changes = all.map(|all| all.links.iter());
                    let all = implicit.and_then(|terms| terms.chart);
                    let mut charts = all.map(|all| all.links.iter());
                    let mut bodies = self.links.iter();
                    rooms.3.each_mut().map(|room| {
                        let body = bodies.next().unwrap_or(support::first(&self.links));
                        let subtracted = changes.as_mut().and_then(::core::iter::Iterator::next);
                        let chart = charts.as_mut().and_then(::core::iter::Iterator::next);
                        let state = states.next().copied();
                        ::ffrf::mechanism::BodyPort::new(
                            body,
                            &self.markers_of_links,
                            state.unwrap_or_else(|| ::ffrf::State::<_, T>::at_rest(body)),
                            implicit.map(|terms| ::ffrf::mechanism::ImplicitTerms {
                                gamma_h: terms.gamma_h,
                                subtracted: subtracted,
                                chart: chart,
                            }),
                            (support::absent(), ()),
                            room,
                        )
                    })
                },
            }
        }
        fn collect(&self, ports: &Self::Ports<'_>, increment: &Self::Increment) -> Self::Increment {
            let mut rates = *increment;
            for (own, other) in ::core::slice::from_mut(&mut rates.crank)
                .iter_mut()
                .zip(::core::slice::from_ref(&ports.crank))
            {
                *own = other.rate(own);
            }
            for (own, other) in
                ::core::slice::from_mut(&mut rates.rod).iter_mut().zip(::core::slice::from_ref(&ports.rod))
            {
                *own = other.rate(own);
            }
            for (own, other) in ::core::slice::from_mut(&mut rates.piston)
                .iter_mut()
                .zip(::core::slice::from_ref(&ports.piston))
            {
                *own = other.rate(own);
            }
            for (own, other) in rates.links.as_mut_slice().iter_mut().zip(ports.links.as_slice()) {
                *own = other.rate(own);
            }
            rates
        }
        fn correct(&self, ports: &mut Self::Ports<'_>, level: ::ffrf::mechanism::Level) {
            for port in ::core::slice::from_mut(&mut ports.crank) {
                port.correct(level);
            }
            for port in ::core::slice::from_mut(&mut ports.rod) {
                port.correct(level);
            }
            for port in ::core::slice::from_mut(&mut ports.piston) {
                port.correct(level);
            }
            for port in ports.links.as_mut_slice() {
                port.correct(level);
            }
        }
        fn state(&self, ports: Self::Ports<'_>) -> Self::State {
            SliderCrankState {
                crank: ports.crank.state,
                rod: ports.rod.state,
                piston: ports.piston.state,
                links: ports.links.map(|port| port.state),
            }
        }
        fn with_storage<R>(
            &self,
            equations: ::ffrf::mechanism::Equations,
            use_it: impl FnOnce(&mut ::ffrf::mechanism::Storage<'_, T>) -> R,
        ) -> R {
            match equations {
                places::Equations::SoftRows => use_it(&mut ::ffrf::mechanism::Storage {
                    blocks: &mut support::absent::<_, 40usize>(),
                    solution: &mut [[::ffrf::generated_support::constant::<T>(0.0); 6]; 15usize],
                    right: &mut [[::ffrf::generated_support::constant::<T>(0.0); 6]; 15usize],
                    shift: &mut [[::ffrf::generated_support::constant::<T>(0.0); 6]; 15usize],
                    efforts: &mut [::ffrf::generated_support::constant::<T>(0.0); 0usize],
                    joints: &mut support::absent::<_, 9usize>(),
                    soft_markers: &mut [[0; 2]; 1usize],
                    limbs: &mut support::absent::<_, 0>(),
                    freedoms: &mut support::absent::<_, 0>(),
                }),
                _ => use_it(&mut ::ffrf::mechanism::Storage {
                    blocks: &mut support::absent::<_, 33usize>(),
                    solution: &mut [[::ffrf::generated_support::constant::<T>(0.0); 6]; 14usize],
                    right: &mut [[::ffrf::generated_support::constant::<T>(0.0); 6]; 14usize],
                    shift: &mut [[::ffrf::generated_support::constant::<T>(0.0); 6]; 14usize],
                    efforts: &mut [::ffrf::generated_support::constant::<T>(0.0); 0usize],
                    joints: &mut support::absent::<_, 8usize>(),
                    soft_markers: &mut [[0; 2]; 0usize],
                    limbs: &mut support::absent::<_, 0>(),
                    freedoms: &mut support::absent::<_, 0>(),
                }),
            }
        }
        fn plan(&self) -> ::ffrf::mechanism::Plan<'_> {
            places::Plan {
                elimination: places::Elimination {
                    steps: &STEPS,
                    leading: 6usize,
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
        fn connections(&self) -> &[::ffrf::mechanism::Connection<T>] {
            &self.connections
        }
        fn joint_name(&self, joint: usize) -> &'static str {
            match Self::JOINTS.get(joint) {
                ::core::option::Option::Some(name) => name,
                ::core::option::Option::None => "",
            }
        }
        fn drive(&self, joint: usize, time: T) -> [T; 3] {
            let none = [::ffrf::generated_support::constant::<T>(0.0); 3];
            match joint {
                1usize => self.motor.at(time),
                _ => none,
            }
        }
        fn load(&self, time: T, ports: &mut Self::Ports<'_>) {
            for port in ::core::slice::from_mut(&mut ports.crank) {
                ::ffrf::mechanism::Port::weigh(port, &self.gravity);
            }
            for port in ::core::slice::from_mut(&mut ports.rod) {
                ::ffrf::mechanism::Port::weigh(port, &self.gravity);
            }
            for port in ::core::slice::from_mut(&mut ports.piston) {
                ::ffrf::mechanism::Port::weigh(port, &self.gravity);
            }
            for port in ports.links.as_mut_slice() {
                ::ffrf::mechanism::Port::weigh(port, &self.gravity);
            }
            self.brake.apply(ports);
        }
        fn soft_plan(&self) -> ::ffrf::mechanism::Plan<'_> {
            soft_plan()
        }
        fn soft(&self, index: usize) -> ::core::option::Option<::ffrf::mechanism::SoftLink<'_, T>> {
            match index {
                0usize => ::core::option::Option::Some(self.brake.soft()),
                _ => ::core::option::Option::None,
            }
        }
        fn energy(&self, state: &Self::State) -> ::ffrf::mechanism::Energy<T> {
            let mut sum = ::ffrf::mechanism::Energy::none();
            for (own, other) in
                ::core::slice::from_ref(&self.crank).iter().zip(::core::slice::from_ref(&state.crank))
            {
                sum.add_body(own, other, &self.gravity);
            }
            for (own, other) in
                ::core::slice::from_ref(&self.rod).iter().zip(::core::slice::from_ref(&state.rod))
            {
                sum.add_body(own, other, &self.gravity);
            }
            for (own, other) in
                ::core::slice::from_ref(&self.piston).iter().zip(::core::slice::from_ref(&state.piston))
            {
                sum.add_body(own, other, &self.gravity);
            }
            for (own, other) in self.links.as_slice().iter().zip(state.links.as_slice()) {
                sum.add_body(own, other, &self.gravity);
            }
            let mut rooms = ::ffrf::mechanism::Assembly::rooms(self);
            let ports =
                ::ffrf::mechanism::Assembly::ports(self, &mut rooms, *state, ::core::option::Option::None);
            sum.potential += self.brake.energy(&ports);
            sum
        }
        fn momentum(&self, state: &Self::State) -> ::ffrf::mechanism::Momentum<T> {
            let mut sum = ::ffrf::mechanism::Momentum::none();
            for (own, other) in
                ::core::slice::from_ref(&self.crank).iter().zip(::core::slice::from_ref(&state.crank))
            {
                sum.add_body(own, other);
            }
            for (own, other) in
                ::core::slice::from_ref(&self.rod).iter().zip(::core::slice::from_ref(&state.rod))
            {
                sum.add_body(own, other);
            }
            for (own, other) in
                ::core::slice::from_ref(&self.piston).iter().zip(::core::slice::from_ref(&state.piston))
            {
                sum.add_body(own, other);
            }
            for (own, other) in self.links.as_slice().iter().zip(state.links.as_slice()) {
                sum.add_body(own, other);
            }
            sum
        }
        fn treatment(&self) -> ::ffrf::mechanism::Treatment<T> {
            self.treatment
        }
        fn regularisation(&self) -> ::ffrf::mechanism::Regularisation<T> {
            self.regularisation
        }
        fn is_finite(&self, state: &Self::State) -> bool {
            ::core::slice::from_ref(&state.crank).iter().all(::ffrf::State::is_finite)
                && ::core::slice::from_ref(&state.rod).iter().all(::ffrf::State::is_finite)
                && ::core::slice::from_ref(&state.piston).iter().all(::ffrf::State::is_finite)
                && state.links.as_slice().iter().all(::ffrf::State::is_finite)
        }
        fn no_change(&self, state: &Self::State) -> Self::Increment {
            SliderCrankIncrement {
                crank: ::ffrf::Increment::zeros(&state.crank.modal_coordinates),
                rod: ::ffrf::Increment::zeros(&state.rod.modal_coordinates),
                piston: ::ffrf::Increment::zeros(&state.piston.modal_coordinates),
                links: state.links.map(|state| ::ffrf::Increment::zeros(&state.modal_coordinates)),
            }
        }
        fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State {
            let mut state = *origin;
            for (own, other) in ::core::slice::from_mut(&mut state.crank)
                .iter_mut()
                .zip(::core::slice::from_ref(&increment.crank))
            {
                *own = own.retract(other);
            }
            for (own, other) in ::core::slice::from_mut(&mut state.rod)
                .iter_mut()
                .zip(::core::slice::from_ref(&increment.rod))
            {
                *own = own.retract(other);
            }
            for (own, other) in ::core::slice::from_mut(&mut state.piston)
                .iter_mut()
                .zip(::core::slice::from_ref(&increment.piston))
            {
                *own = own.retract(other);
            }
            for (own, other) in state.links.as_mut_slice().iter_mut().zip(increment.links.as_slice()) {
                *own = own.retract(other);
            }
            state
        }
        fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment {
            let mut rates = *increment;
            for (own, other) in ::core::slice::from_mut(&mut rates.crank)
                .iter_mut()
                .zip(::core::slice::from_ref(&origin.crank))
            {
                *own = own.place_rate(&other.retract(own));
            }
            for (own, other) in
                ::core::slice::from_mut(&mut rates.rod).iter_mut().zip(::core::slice::from_ref(&origin.rod))
            {
                *own = own.place_rate(&other.retract(own));
            }
            for (own, other) in ::core::slice::from_mut(&mut rates.piston)
                .iter_mut()
                .zip(::core::slice::from_ref(&origin.piston))
            {
                *own = own.place_rate(&other.retract(own));
            }
            for (own, other) in rates.links.as_mut_slice().iter_mut().zip(origin.links.as_slice()) {
                *own = own.place_rate(&other.retract(own));
            }
            rates
        }
        fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment {
            let mut increment = *increment;
            for port in ::core::slice::from_mut(&mut increment.crank) {
                *port = port.velocities_only();
            }
            for port in ::core::slice::from_mut(&mut increment.rod) {
                *port = port.velocities_only();
            }
            for port in ::core::slice::from_mut(&mut increment.piston) {
                *port = port.velocities_only();
            }
            for port in increment.links.as_mut_slice() {
                *port = port.velocities_only();
            }
            increment
        }
        fn local_error(&self, difference: &Self::Increment) -> ::ffrf::LocalError<T> {
            let mut error = ::ffrf::LocalError {
                position: ::ffrf::generated_support::constant::<T>(0.0),
                orientation: ::ffrf::generated_support::constant::<T>(0.0),
                modal_coordinates: ::ffrf::generated_support::constant::<T>(0.0),
            };
            for part in ::core::slice::from_ref(&difference.crank) {
                error = error.or(part.local_error());
            }
            for part in ::core::slice::from_ref(&difference.rod) {
                error = error.or(part.local_error());
            }
            for part in ::core::slice::from_ref(&difference.piston) {
                error = error.or(part.local_error());
            }
            for part in difference.links.as_slice() {
                error = error.or(part.local_error());
            }
            error
        }
        fn weighted_error(
            &self,
            state: &Self::State,
            difference: &Self::Increment,
            tolerances: &::ffrf::Tolerances<T>,
        ) -> T {
            let (mut sum, mut count) = (
                ::ffrf::generated_support::constant::<T>(0.0),
                ::ffrf::generated_support::constant::<T>(0.0),
            );
            for (state, part) in
                ::core::slice::from_ref(&state.crank).iter().zip(::core::slice::from_ref(&difference.crank))
            {
                let (squares, number) = part.weighted_squares(state, tolerances);
                sum += squares;
                count += number;
            }
            for (state, part) in
                ::core::slice::from_ref(&state.rod).iter().zip(::core::slice::from_ref(&difference.rod))
            {
                let (squares, number) = part.weighted_squares(state, tolerances);
                sum += squares;
                count += number;
            }
            for (state, part) in
                ::core::slice::from_ref(&state.piston).iter().zip(::core::slice::from_ref(&difference.piston))
            {
                let (squares, number) = part.weighted_squares(state, tolerances);
                sum += squares;
                count += number;
            }
            for (state, part) in state.links.as_slice().iter().zip(difference.links.as_slice()) {
                let (squares, number) = part.weighted_squares(state, tolerances);
                sum += squares;
                count += number;
            }
            ::ffrf::nalgebra::ComplexField::sqrt(sum / count)
        }
        fn largest_stable_step(&self) -> ::core::option::Option<T> {
            let mut least: ::core::option::Option<T> = ::core::option::Option::None;
            for body in ::core::slice::from_ref(&self.crank) {
                if let ::core::option::Option::Some(step) =
                    ::ffrf::FlexibleBody::<T>::largest_stable_step(body)
                {
                    least = ::core::option::Option::Some(match least {
                        ::core::option::Option::Some(other) if other < step => other,
                        _ => step,
                    });
                }
            }
            for body in ::core::slice::from_ref(&self.rod) {
                if let ::core::option::Option::Some(step) =
                    ::ffrf::FlexibleBody::<T>::largest_stable_step(body)
                {
                    least = ::core::option::Option::Some(match least {
                        ::core::option::Option::Some(other) if other < step => other,
                        _ => step,
                    });
                }
            }
            for body in ::core::slice::from_ref(&self.piston) {
                if let ::core::option::Option::Some(step) =
                    ::ffrf::FlexibleBody::<T>::largest_stable_step(body)
                {
                    least = ::core::option::Option::Some(match least {
                        ::core::option::Option::Some(other) if other < step => other,
                        _ => step,
                    });
                }
            }
            for body in self.links.as_slice() {
                if let ::core::option::Option::Some(step) =
                    ::ffrf::FlexibleBody::<T>::largest_stable_step(body)
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
