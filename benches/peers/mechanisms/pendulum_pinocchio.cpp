// The rigid pendulum by Pinocchio's articulated-body algorithm. usage: pendulum_pinocchio ROUNDS N [N ...]
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>

#include "pendulum.h"

int main(int argc, char **argv) {
    int rounds = atoi(argv[1]);
    for (int a = 2; a < argc; a++) {
        int n = atoi(argv[a]);
        pinocchio::Model model;
        model.gravity.linear() = Eigen::Vector3d(0, -9.81, 0);
        const Eigen::Vector3d center(0.15, 0, 0), inertia(1e-3, 5e-3, 5e-3);
        pinocchio::JointIndex parent = 0;
        for (int k = 0; k < n; k++) {
            pinocchio::SE3 place = pinocchio::SE3::Identity();
            if (k) place.translation() = Eigen::Vector3d(0.3, 0, 0);
            parent = model.addJoint(parent, pinocchio::JointModelRZ(), place, "joint" + std::to_string(k));
            const Eigen::Matrix3d tensor = inertia.asDiagonal();
            model.appendBodyToJoint(parent, pinocchio::Inertia(0.6, center, tensor), pinocchio::SE3::Identity());
        }
        pinocchio::Data data(model);
        Eigen::VectorXd q(n), v(n), torque = Eigen::VectorXd::Zero(n);
        for (int k = 0; k < n; k++) q[k] = joint_angle(k), v[k] = joint_rate(k);
        double best;
        LEAST(best, rounds, pinocchio::aba(model, data, q, v, torque, pinocchio::Convention::LOCAL));
        report("pendulum, Pinocchio aba local", n, best, data.ddq.data());
        LEAST(best, rounds, pinocchio::aba(model, data, q, v, torque, pinocchio::Convention::WORLD));
        report("pendulum, Pinocchio aba world", n, best, data.ddq.data());
    }
}
