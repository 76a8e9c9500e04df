#include "sim/hinge_ties.h"
#include "sim/integrator.h"

namespace nao::sim {
namespace {

class Rk4 final : public Integrator {
 public:
  Rk4(const BodyPlan& plan, TreeDynamics& dynamics, const Eigen::VectorXd& rotor_inertia)
      : plan_(plan),
        dynamics_(dynamics),
        rotor_inertia_(rotor_inertia),
        matrix_(dynamics.parents()),
        ties_(plan.model, dynamics.rootSpeedCount()),
        torque_(dynamics.speedCount()) {}

  void step(SmoothForces& forces, double h, TreeState& tree) override {
    const Slope a = slope(forces, tree);
    const Slope b = slope(forces, moved(tree, a, h / 2));
    const Slope c = slope(forces, moved(tree, b, h / 2));
    const Slope d = slope(forces, moved(tree, c, h));
    tree.q += h / 6 * (a.q + 2 * b.q + 2 * c.q + d.q);
    tree.u += h / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
    if (dynamics_.rootPositionCount() > 0) tree.q.head<4>().normalize();
  }

  Eigen::VectorXd calcAcceleration(SmoothForces& forces, const TreeState& tree) override {
    dynamics_.setState(tree);
    dynamics_.calcBias(plan_.gravity, bias_);
    forces.calc(tree.q.data() + dynamics_.rootPositionCount(),
                tree.u.data() + dynamics_.rootSpeedCount(), dynamics_.motion(), torque_,
                on_bodies_);
    dynamics_.calcMassMatrix(matrix_);
    matrix_.addDiagonal(rotor_inertia_);
    Eigen::VectorXd acceleration = torque_ - bias_;
    addForces(acceleration);
    matrix_.factor();
    matrix_.solve(acceleration);
    tieSharedHinges(acceleration);
    return acceleration;
  }

 private:
  struct Slope {  // rates of change of a TreeState
    Eigen::VectorXd q, u;
  };

  static TreeState moved(const TreeState& from, const Slope& slope, double h) {
    return {from.q + h * slope.q, from.u + h * slope.u};
  }

  Slope slope(SmoothForces& forces, const TreeState& tree) {
    return {rateOf(tree, dynamics_.rootPositionCount(), dynamics_.rootSpeedCount()),
            calcAcceleration(forces, tree)};
  }

  void addForces(Eigen::VectorXd& f) {
    TreeDynamics::PointJacobian jacobian;
    for (const ExternalForce& force : on_bodies_) {
      dynamics_.calcPointJacobian(force.body, force.p_W, jacobian);
      for (int axis = 0; axis < 3; ++axis) {
        matrix_.addScaled(jacobian.leaf, jacobian.row[axis], force.f_W[axis], f);
      }
    }
  }

  // Hinges of one motor speed up alike.
  void tieSharedHinges(Eigen::VectorXd& acceleration) {
    ties_.hold([this](Eigen::VectorXd& c) { matrix_.solve(c); }, [](int, int) { return 0.0; },
               acceleration);
  }

  // q' from u: the quaternion turns with the angular velocity in W, the rest as it is.
  static Eigen::VectorXd rateOf(const TreeState& tree, int root_q, int root_u) {
    Eigen::VectorXd rate(tree.q.size());
    if (root_q > 0) {
      const Vec3 w = tree.u.head<3>();
      const Vec3 v = tree.q.segment<3>(1);
      rate[0] = -0.5 * w.dot(v);
      rate.segment<3>(1) = 0.5 * (tree.q[0] * w + w.cross(v));
      rate.segment<3>(4) = tree.u.segment<3>(3);
    }
    rate.tail(tree.q.size() - root_q) = tree.u.tail(tree.u.size() - root_u);
    return rate;
  }

  const BodyPlan& plan_;
  TreeDynamics& dynamics_;
  const Eigen::VectorXd& rotor_inertia_;
  TreeMatrix matrix_;
  HingeTies ties_;
  Eigen::VectorXd torque_, bias_;
  std::vector<ExternalForce> on_bodies_;
};

}  // namespace

std::unique_ptr<Integrator> makeRk4(const BodyPlan& plan, TreeDynamics& dynamics,
                                    const Eigen::VectorXd& rotor_inertia) {
  return std::make_unique<Rk4>(plan, dynamics, rotor_inertia);
}

}  // namespace nao::sim
