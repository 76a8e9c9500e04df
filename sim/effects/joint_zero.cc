// Every joint's encoder is mounted a little turned, differently in every run: its joint is at
// N(0, sd) when it reads 0, for servo and report alike.
// Source: "1 degree absolute error is not exceptional" (NAOqi 2.1.4.13 documentation, mre).
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class JointZero final : public Effect {
 public:
  explicit JointZero(const EffectSetup& setup) : model_(setup.model), joints_(setup.hinged()) {
    Random random = setup.random;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      zero_.push_back(setup.value("sd") * random.normal());
    }
  }

  void alterPlan(BodyPlan& plan) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) plan.joint_zero[joints_[i]] += zero_[i];
  }

  void listDraw(std::map<std::string, double>& draw) const override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      draw[model_.actuators[joints_[i]].name] = zero_[i];
    }
  }

 private:
  const RobotModel& model_;
  std::vector<std::size_t> joints_;
  std::vector<double> zero_;  // [rad]
};

}  // namespace

EffectType jointZero() {
  return {"joint_zero",
          "Each joint's encoder has a zero error of its own, drawn once per run.",
          {{"sd", "rad", 0.3 * M_PI / 180, 0, 0, 0.2, 0.05 * M_PI / 180}},
          Acts::Once,
          makeEffect<JointZero>};
}

}  // namespace nao::sim
