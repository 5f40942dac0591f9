/* The rigid pendulum by MuJoCo, called from C. usage: pendulum_mujoco ROUNDS MODEL.xml N [MODEL.xml N ...]
 * Timed twice: mj_forward, which is everything but the step in time; and only what accelerations of a tree need
 * (kinematics, inertia, factorisation, bias forces, solution) without sensors, energy, actuators and collisions. */
#include <mujoco/mujoco.h>

#include "pendulum.h"

static void lean(const mjModel *m, mjData *d) {
    mj_kinematics(m, d);
    mj_comPos(m, d);
    mj_makeM(m, d);
    mj_factorM(m, d);
    mj_comVel(m, d);
    mj_rne(m, d, 0, d->qfrc_bias);
    mju_scl(d->qacc, d->qfrc_bias, -1, m->nv);
    mj_solveM(m, d, d->qacc, d->qacc, 1);
}

int main(int argc, char **argv) {
    int rounds = atoi(argv[1]);
    for (int a = 2; a + 1 < argc; a += 2) {
        char error[500];
        mjModel *m = mj_loadXML(argv[a], 0, error, sizeof error);
        if (!m) return fprintf(stderr, "%s\n", error), 1;
        int n = atoi(argv[a + 1]);
        if (m->nv != n) return fprintf(stderr, "%d joints, expected %d\n", (int)m->nv, n), 1;
        mjData *d = mj_makeData(m);
        for (int k = 0; k < n; k++) d->qpos[k] = joint_angle(k), d->qvel[k] = joint_rate(k);
        double best;
        LEAST(best, rounds, mj_forward(m, d));
        report("pendulum, MuJoCo mj_forward", n, best, d->qacc);
        LEAST(best, rounds, lean(m, d));
        report("pendulum, MuJoCo lean", n, best, d->qacc);
        mj_deleteData(d), mj_deleteModel(m);
    }
    return 0;
}
