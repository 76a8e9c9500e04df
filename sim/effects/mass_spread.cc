// No two robots weigh the same: the mass and inertia of every body are those of the model times
// 1 + U(-part, part), drawn once per run; centres of mass stay. Source: the thesis' question how
// far a motion bears it; 0.05 is what its experiments ask.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class MassSpread final : public Effect {
 public:
  explicit MassSpread(const EffectSetup& setup) {
    Random random = setup.random;
    const double part = setup.value("part");
    for (const Body& body : setup.model.bodies) {
      names_.push_back(body.name);
      factors_.push_back(1 + random.uniform(-part, part));
    }
  }

  void alterPlan(BodyPlan& plan) override {
    for (std::size_t b = 0; b < factors_.size(); ++b) {
      plan.model.bodies[b].mass *= factors_[b];
      plan.model.bodies[b].I_Bcm *= factors_[b];
    }
  }

  void listDraw(std::map<std::string, double>& draw) const override {
    for (std::size_t b = 0; b < factors_.size(); ++b) draw[names_[b]] = factors_[b];
  }

 private:
  std::vector<std::string> names_;
  std::vector<double> factors_;
};

}  // namespace

EffectType massSpread() {
  return {"mass_spread",
          "Every body is a little heavier or lighter than the model says, drawn once per run.",
          {{"part", "", 0.05, 0, 0, 0.9, 0.01}},
          Acts::Once,
          makeEffect<MassSpread>};
}

}  // namespace nao::sim
