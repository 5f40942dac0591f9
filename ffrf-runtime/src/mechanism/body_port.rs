//! The workspace of one body in a mechanism.

use nalgebra::{Matrix3, RealField, Vector3, Vector6};

use super::kept_modes::copy_from;
use super::room::attached;
use super::solved::Solved;
use super::support::Supported;
use super::{AttachedRows, ImplicitTerms, Keeping, Level, Phase, Port, RigidFrame, Room};
use crate::body::{
    FlexibleBody, GeneralisedForce, ImplicitBody, Increment, Marker, MarkerMotion, MarkerStep, ModalVector,
    Motion, Span, SpanMarker, State, Wrench, implicit_modal_mass, marker_motion, move_rigidly, with_placed,
};
use crate::integrators::StepError;
use crate::rotation::matrix;
use crate::six::{Square, add_products, dot, scaled, six_times, subtract_scaled, zeros};

/// One body in one state, with its forces; what the equations need besides is in its [`Room`], whose parameters are `R` and `K`.
#[derive(Debug)]
pub struct BodyPort<'a, B: FlexibleBody<T>, R, T: RealField + Copy, K = ()> {
    pub(super) body: &'a B,
    pub(super) markers: &'a [Marker<B::Modal, T>],
    /// The state of this evaluation.
    pub state: State<B::Modal, T>,
    /// The axes of the body in this state as columns. Frame: inertial.
    pub(super) axes: Matrix3<T>,
    /// Force of loads and force elements so far.
    pub force: GeneralisedForce<B::Modal, T>,
    /// The result: accelerations, or a correction of place or velocities.
    pub motion: Motion<B::Modal, T>,
    pub(super) implicit: Option<ImplicitTerms<'a, Increment<B::Modal, T>, T>>,
    pub(super) net: GeneralisedForce<B::Modal, T>,
    pub(super) alone: B::Modal,
    pub(super) room: &'a mut Room<B::Modal, R, T, K>,
}

impl<'a, B, R, T, K> BodyPort<'a, B, R, T, K>
where
    B: FlexibleBody<T>,
    R: AsRef<[Option<AttachedRows<B::Modal, T>>]> + AsMut<[Option<AttachedRows<B::Modal, T>>]>,
    T: RealField + Copy,
    K: Keeping<B::Modal, T>,
{
    /// A body in a state, without forces. `rows`: places for those of the joints on it; `kept`: room for its modes if it keeps
    /// them as unknowns; `room`: what was there is replaced.
    // inlined, so that it is made where it stays
    #[inline(always)]
    pub fn new(
        body: &'a B,
        markers: &'a [Marker<B::Modal, T>],
        state: State<B::Modal, T>,
        implicit: Option<ImplicitTerms<'a, Increment<B::Modal, T>, T>>,
        (rows, kept): (R, K),
        room: &'a mut Option<Room<B::Modal, R, T, K>>,
    ) -> Self {
        let zeros = body.undeformed();
        Self {
            body,
            markers,
            axes: matrix(&state.orientation),
            state,
            force: GeneralisedForce::zeros(&zeros),
            motion: Motion::zeros(&zeros),
            implicit,
            net: GeneralisedForce::zeros(&zeros),
            alone: zeros,
            room: room.insert(Room::new(rows, kept)),
        }
    }

    /// The rate of `increment`, which has led to this state, from the resulting accelerations.
    ///
    /// In a step of the energy-momentum method: the change of the places over the step, and the correction of velocities.
    pub fn rate(&self, increment: &Increment<B::Modal, T>) -> Increment<B::Modal, T> {
        let accelerations = self.motion.clone();
        if let Some((span, _)) = &self.room.span {
            return span.with_correction(&accelerations);
        }
        match self.implicit {
            None => increment.rate(&self.state, accelerations),
            Some(ImplicitTerms { gamma_h, subtracted, chart }) => {
                let mut rate = increment.implicit_rate(&self.state, accelerations, gamma_h, subtracted);
                if chart.is_some() {
                    increment.follow_end(&mut rate, gamma_h);
                }
                rate
            }
        }
    }

    /// Place and motion of any marker of this body, one that no joint uses among them.
    pub fn motion_of(&self, marker: &Marker<B::Modal, T>) -> MarkerMotion<T> {
        match &self.room.span {
            Some((span, Phase::End)) => {
                marker_motion(self.body, marker, &span.end, &matrix(&span.end.orientation))
            }
            Some((span, Phase::Mean)) => SpanMarker::new(self.body, marker, span).motion(),
            None => marker_motion(self.body, marker, &self.state, &self.axes),
        }
    }

    /// Adds a wrench (inertial) at any marker of this body to the force on it.
    pub fn push_at(&mut self, marker: &Marker<B::Modal, T>, wrench: &Wrench<T>) {
        let force = self.force_of(marker, wrench);
        self.force.add_scaled(T::one(), &force);
    }

    fn force_of(&self, marker: &Marker<B::Modal, T>, wrench: &Wrench<T>) -> GeneralisedForce<B::Modal, T> {
        match &self.room.span {
            Some((span, _)) => SpanMarker::new(self.body, marker, span).generalised_force(wrench),
            None => with_placed(self.body, marker, &self.state, &self.axes, |placed| {
                placed.generalised_force(wrench)
            }),
        }
    }

    /// Measures the factors that were made.
    fn measure(&mut self) -> Result<(), StepError> {
        let eliminated = self.room.solved.eliminated().ok_or(StepError::MassNotPositive)?;
        let positive = |mass: T| if mass > T::zero() { T::one() / mass } else { T::zero() };
        if self.alone.as_slice().is_empty() {
            // the mean axes of a step of the energy-momentum method are none to resolve in
            let axes = if self.room.span.is_some() { &Matrix3::identity() } else { &self.axes };
            let frame = RigidFrame::new(&eliminated.remaining, axes);
            self.room.yields = Some(frame.masses().map(positive));
            self.room.frame = Some(frame);
        } else {
            let mass = &eliminated.remaining.data.0;
            let yields = self.room.yields.insert([T::zero(); 6]);
            six_times!(K: { yields[K] = positive(mass[K][K]); });
        }
        Ok(())
    }

    /// Applies the resulting motion to the state: a displacement, or a change of velocity.
    pub fn correct(&mut self, level: Level) {
        match level {
            Level::Position => self.state.displace(&self.motion),
            Level::Velocity => self.state.push(&self.motion),
        }
        self.axes = matrix(&self.state.orientation);
    }

    fn generalised_force(&self, index: usize, wrench: &Wrench<T>) -> Option<GeneralisedForce<B::Modal, T>> {
        Some(self.force_of(self.markers.get(index)?, wrench))
    }

    fn twist(&self, index: usize, motion: &Motion<B::Modal, T>) -> [Vector3<T>; 2] {
        let Some(marker) = self.markers.get(index) else { return [Vector3::zeros(); 2] };
        with_placed(self.body, marker, &self.state, &self.axes, |placed| placed.twist(motion))
    }
}

impl<B, R, T, K> Port<T> for BodyPort<'_, B, R, T, K>
where
    B: FlexibleBody<T>,
    R: AsRef<[Option<AttachedRows<B::Modal, T>>]> + AsMut<[Option<AttachedRows<B::Modal, T>>]>,
    T: RealField + Copy,
    K: Keeping<B::Modal, T>,
{
    fn marker_motion(&self, index: usize, to: &mut MarkerMotion<T>) {
        match self.markers.get(index) {
            Some(marker) if self.alone.as_slice().is_empty() && self.room.span.is_none() => {
                move_rigidly(to, &marker.position, &self.state, &self.axes);
            }
            Some(marker) => *to = self.motion_of(marker),
            None => *to = MarkerMotion::fixed(self.state.position, self.state.orientation),
        }
    }

    fn marker_step(&self, marker: usize) -> Option<MarkerStep<T>> {
        let ((span, _), marker) = (self.room.span.as_ref()?, self.markers.get(marker)?);
        let at = SpanMarker::new(self.body, marker, span);
        Some(MarkerStep { ends: at.ends(), mean: at.motion(), step: span.step })
    }

    fn push(&mut self, marker: usize, wrench: &Wrench<T>) {
        if let Some(force) = self.generalised_force(marker, wrench) {
            self.force.add_scaled(T::one(), &force);
        }
    }

    fn weigh(&mut self, gravity: &Vector3<T>) {
        if let Some((span, _)) = &self.room.span {
            self.force.add_scaled(T::one(), &span.weight(self.body, gravity));
            return;
        }
        let resolved = self.axes.tr_mul(gravity);
        let weight = self.body.gravity_force(&self.state.modal_coordinates, &resolved);
        self.force.add_scaled(T::one(), &weight);
    }

    fn conserve(&mut self, phase: Phase) {
        match (&mut self.room.span, self.implicit) {
            (Some((_, shown)), _) => *shown = phase,
            (place, Some(ImplicitTerms { gamma_h, subtracted: Some(velocities), .. })) => {
                let span = Span::new(&self.state, velocities, gamma_h + gamma_h);
                self.state = span.middle.clone();
                self.axes = matrix(&self.state.orientation);
                *place = Some((span, phase));
            }
            _ => {}
        }
    }

    fn factor(&mut self) -> Result<(), StepError> {
        if let Some((span, _)) = &self.room.span {
            let (stage, missing) = span.stage(self.body, &self.force).ok_or(StepError::MassNotPositive)?;
            self.net = missing;
            if let Some(kept) = self.room.kept.kept_mut() {
                let gamma_h = span.step * nalgebra::convert(0.5);
                kept.keep(&stage.prepared, implicit_modal_mass(self.body, gamma_h));
            }
            self.room.solved = Solved::Rows(stage.eliminated);
            return self.measure();
        }
        let (body, state) = (self.body, &self.state);
        match self.implicit {
            None => {
                let prepared =
                    body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
                self.net = prepared.net_force(&self.force);
                if let Some(kept) = self.room.kept.kept_mut() {
                    kept.keep(&prepared, body.modal_mass());
                }
                // made where it stays
                self.room.solved =
                    Solved::of_rows(body.modal_mass().factor().map(|modal| prepared.eliminate(modal)));
            }
            Some(ImplicitTerms { gamma_h, subtracted, .. }) => {
                self.room.solved = Solved::of_rows(ImplicitBody::new(body, state, gamma_h).map(|stage| {
                    self.net = stage.right(body, state, &self.force, subtracted);
                    if let Some(kept) = self.room.kept.kept_mut() {
                        kept.keep(&stage.prepared, implicit_modal_mass(body, gamma_h));
                    }
                    stage.eliminated
                }));
            }
        }
        self.measure()
    }

    #[cold]
    fn indefinite(&self) -> Option<T> {
        let eliminated = self.room.solved.eliminated().cloned();
        eliminated
            .and_then(|eliminated| eliminated.factor())
            .is_none()
            .then(|| self.state.modal_coordinates.largest())
    }

    fn rigid_mass(&self, to: &mut Square<T>) {
        if let Some(kept) = self.room.kept.kept() {
            *to = kept.rigid_mass();
            return;
        }
        match (&self.room.frame, self.room.solved.eliminated()) {
            (Some(frame), _) => {
                let masses = self.room.supported.as_ref().map_or(*frame.masses(), Supported::masses);
                six_times!(K: { to[K][K] = masses[K]; });
            }
            (None, Some(eliminated)) => *to = eliminated.remaining.data.0,
            (None, None) => *to = zeros(),
        }
    }

    fn has_modes(&self) -> bool {
        !self.alone.as_slice().is_empty() && self.room.kept.kept().is_none()
    }

    fn modal_mass(&self, rows: usize, columns: usize, to: &mut Square<T>) {
        if let Some(kept) = self.room.kept.kept() {
            kept.modal_mass(rows, columns, to);
        }
    }

    fn modal_coupling(&self, first: usize, to: &mut Square<T>) {
        if let Some(kept) = self.room.kept.kept() {
            kept.coupling(first, to);
        }
    }

    fn modal_rows(&self, slot: usize, first: usize, to: &mut Square<T>) {
        if let Some(rows) = attached(&self.room.rows, slot) {
            copy_from(rows.modal.as_ref(), first, to);
        }
    }

    fn modal_force(&self, first: usize) -> [T; 6] {
        let mut right = [T::zero(); 6];
        for (place, force) in right.iter_mut().zip(self.net.modal.as_slice().iter().skip(first)) {
            *place = *force;
        }
        right
    }

    fn finish_modes(&mut self, first: usize, modal: &[T; 6]) {
        for (place, entry) in self.motion.modal.as_mut_slice().iter_mut().skip(first).zip(modal) {
            *place = *entry;
        }
    }

    fn attach(
        &mut self,
        slot: usize,
        marker: usize,
        rows: usize,
        gradients: &Square<T>,
        effects: &mut Square<T>,
        compliances: Option<&mut [T; 6]>,
    ) {
        let Room { rows: places, solved, frame, supported, yields, span, kept } = &mut *self.room;
        let (Some(at), Some(place), Some(eliminated)) =
            (self.markers.get(marker), places.as_mut().get_mut(slot), solved.eliminated())
        else {
            return;
        };
        let AttachedRows { modal, weighted, count } = AttachedRows::put(place, &self.alone);
        *count = rows;
        let add_compliances = |compliances: Option<&mut [T; 6]>, effects: &Square<T>| {
            if let (Some(compliances), Some(yields)) = (compliances, yields.as_ref()) {
                for (effect, yields) in effects.iter().zip(yields) {
                    add_products(compliances, effect, &scaled(*yields, effect));
                }
            }
        };
        if let Some(frame) = frame {
            match span {
                Some((span, _)) => {
                    *effects =
                        SpanMarker::new(self.body, at, span).generalised_forces(gradients, modal.as_mut());
                    frame.to_components(effects);
                }
                None => frame.effects(&at.position, gradients, effects),
            }
            add_compliances(compliances, effects);
            if let Some(supported) = supported {
                supported.project(effects);
            }
            return;
        }
        match span {
            Some((span, _)) => {
                *effects = SpanMarker::new(self.body, at, span).generalised_forces(gradients, modal.as_mut());
            }
            None => with_placed(self.body, at, &self.state, &self.axes, |placed| {
                placed.generalised_forces(gradients, effects, modal.as_mut());
            }),
        }
        if kept.kept().is_some() {
            if let Some(compliances) = compliances {
                // what these rows would meet if the modes were eliminated: one measure for all bodies
                let mut met = *effects;
                for (followed, modal) in eliminated.followed.as_ref().iter().zip(modal.as_ref()) {
                    six_times!(K: { subtract_scaled(&mut met[K], followed[K], modal); });
                }
                add_compliances(Some(&mut *compliances), &met);
                let weighted = weighted.get_or_insert_with(|| self.alone.zero_sixes());
                eliminated.modal.solve_sixes_to(weighted, modal);
                for (modal, weighted) in modal.as_ref().iter().zip(weighted.as_ref()) {
                    add_products(compliances, modal, weighted);
                }
            }
            return;
        }
        // component by component, so that the sums stay in registers
        six_times!(K: {
            let mut effect = effects[K];
            for (followed, modal) in eliminated.followed.as_ref().iter().zip(modal.as_ref()) {
                subtract_scaled(&mut effect, followed[K], modal);
            }
            effects[K] = effect;
        });
        add_compliances(compliances, effects);
        let weighted = weighted.get_or_insert_with(|| self.alone.zero_sixes());
        eliminated.modal.solve_sixes_to(weighted, modal);
    }

    fn subtract_compliance(&self, slot: usize, other: usize, from: &mut Square<T>) {
        let places = &self.room.rows;
        let (Some(rows), Some(other)) = (attached(places, slot), attached(places, other)) else { return };
        let Some(weighted) = other.weighted.as_ref().filter(|_| self.room.kept.kept().is_none()) else {
            return;
        };
        six_times!(K: { if K < rows.count {
            let mut row = from[K];
            for (modal, weighted) in rows.modal.as_ref().iter().zip(weighted.as_ref()) {
                subtract_scaled(&mut row, modal[K], weighted);
            }
            from[K] = row;
        } });
    }

    fn reduced_force(&mut self) -> [T; 6] {
        if self.room.kept.kept().is_some() {
            let (force, moment) = (&self.net.force, &self.net.moment);
            return [force.x, force.y, force.z, moment.x, moment.y, moment.z];
        }
        let Some(eliminated) = self.room.solved.eliminated() else { return [T::zero(); 6] };
        self.alone = eliminated.modal.solve(&self.net.modal);
        let force = eliminated.reduced_force(&self.net).into();
        match (&self.room.frame, &self.room.supported) {
            (Some(frame), Some(supported)) => supported.force(frame, frame.force(force)),
            (Some(frame), None) => frame.force(force),
            (None, _) => force,
        }
    }

    fn push_net(&mut self, marker: usize, wrench: &Wrench<T>) {
        let Some(force) = self.generalised_force(marker, wrench) else { return };
        // in a step of the energy-momentum method the right-hand side is an impulse
        let share = self.room.span.as_ref().map_or(T::one(), |(span, _)| span.step);
        self.net.add_scaled(share, &force);
    }

    fn without_force(&mut self) {
        self.alone = self.body.undeformed();
    }

    fn subtract_modal_accelerations(&self, slot: usize, from: &mut [T; 6]) {
        if let Some(rows) = attached(&self.room.rows, slot) {
            for (acceleration, modal) in self.alone.as_slice().iter().zip(rows.modal.as_ref()) {
                subtract_scaled(from, *acceleration, modal);
            }
        }
    }

    fn subtracted_twist(&self, marker: usize) -> Option<[Vector3<T>; 2]> {
        match self.implicit {
            Some(ImplicitTerms { subtracted: Some(subtracted), .. }) => {
                Some(self.twist(marker, &subtracted.velocities(&self.state)))
            }
            _ => None,
        }
    }

    fn subtracted_displacement(&self, marker: usize) -> Option<[Vector3<T>; 2]> {
        match self.implicit {
            Some(ImplicitTerms { subtracted: Some(subtracted), chart: Some(chart), .. }) => {
                Some(self.twist(marker, &subtracted.displacements(chart, &self.state)))
            }
            _ => None,
        }
    }

    fn finish(&mut self, rigid: &[T; 6]) {
        if self.room.kept.kept().is_some() {
            let [x, y, z, r_x, r_y, r_z] = *rigid;
            (self.motion.linear, self.motion.angular) = (Vector3::new(x, y, z), Vector3::new(r_x, r_y, r_z));
            return;
        }
        if let Some(eliminated) = self.room.solved.eliminated() {
            let rigid = match (&self.room.frame, &self.room.supported) {
                (Some(frame), Some(supported)) => frame.motion(&supported.motion(rigid)),
                (Some(frame), None) => frame.motion(rigid),
                (None, _) => *rigid,
            };
            self.motion = eliminated.with_modes(&Vector6::from(rigid), self.alone.clone());
        }
    }

    fn follow(&mut self, slot: usize, negative: &[T; 6]) {
        if let Some(weighted) = attached(&self.room.rows, slot).and_then(|rows| rows.weighted.as_ref()) {
            for (entry, weighted) in self.motion.modal.as_mut_slice().iter_mut().zip(weighted.as_ref()) {
                *entry -= dot(weighted, negative);
            }
        }
    }

    fn resulting_twist(&self, marker: usize) -> [Vector3<T>; 2] {
        self.twist(marker, &self.motion)
    }
}
