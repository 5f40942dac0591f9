//! Arrays of equal bodies.

use ffrf::mechanism;

use crate::bodies::{BIG_END, Rod, SMALL_END};

mechanism! {
    /// Five rods in a row.
    pub struct Chain {
        bodies: { links: [Rod; 5] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            first: revolute(ground, links[0].BIG_END, axis: z),
            hinges: for i in 0..4 { revolute(links[i].SMALL_END, links[i + 1].BIG_END, axis: z) },
        },
        sensors: { end: position(links[4].SMALL_END) },
    }
}

mechanism! {
    /// The same, body by body.
    pub struct Unrolled {
        bodies: { a: Rod, b: Rod, c: Rod, d: Rod, e: Rod },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            first: revolute(ground, a.BIG_END, axis: z),
            second: revolute(a.SMALL_END, b.BIG_END, axis: z),
            third: revolute(b.SMALL_END, c.BIG_END, axis: z),
            fourth: revolute(c.SMALL_END, d.BIG_END, axis: z),
            fifth: revolute(d.SMALL_END, e.BIG_END, axis: z),
        },
        sensors: { end: position(e.SMALL_END) },
    }
}

#[test]
fn an_array_is_its_bodies_one_by_one() {
    let chain = Chain::new([Rod; 5]);
    let unrolled = Unrolled::new(Rod, Rod, Rod, Rod, Rod);
    assert_eq!(Chain::JOINTS, ["first", "hinges[0]", "hinges[1]", "hinges[2]", "hinges[3]"]);
    let mut state = chain.at_rest();
    for (k, link) in state.links.iter_mut().enumerate() {
        link.position.x = k as f64 * (SMALL_END - BIG_END) - BIG_END;
    }
    let other = unrolled.state_from_array(&state.to_array());
    let (mut one, mut two) = (chain.in_motion(state), unrolled.in_motion(other));
    for _ in 0..50 {
        let reports = [one.step_rk4(5e-6).unwrap(), two.step_rk4(5e-6).unwrap()];
        assert_eq!(reports[0], reports[1]);
    }
    for _ in 0..50 {
        assert_eq!(one.step_linearly_implicit(1e-4).unwrap(), two.step_linearly_implicit(1e-4).unwrap());
    }
    assert_eq!(one.state.to_array(), two.state.to_array());
    assert_eq!(chain.end(&one.state), unrolled.end(&two.state));
    assert!(chain.end(&one.state).y < -1e-5);
}
