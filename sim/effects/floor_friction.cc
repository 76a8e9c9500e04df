// The floor is another one in every run: its friction coefficient is U(low, high), whatever the
// world says; high = 0 leaves the world's. Source: dust and wear; 0.5 to 0.8 is an estimate for
// plastic soles on carpet and wood.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class FloorFriction final : public Effect {
 public:
  explicit FloorFriction(const EffectSetup& setup) {
    Random random = setup.random;
    const double high = setup.value("high");
    friction_ = random.uniform(std::min(setup.value("low"), high), high);
  }

  void alterPlan(BodyPlan& plan) override {
    if (friction_ > 0) plan.ground.friction = friction_;
  }

  void listDraw(std::map<std::string, double>& draw) const override {
    draw["friction"] = friction_;
  }

 private:
  double friction_;
};

}  // namespace

EffectType floorFriction() {
  return {"floor_friction",
          "How slippery the floor is, drawn once per run.",
          {{"low", "", 0.5, 0, 0, 5, 0.02}, {"high", "", 0.8, 0, 0, 5, 0.02}},
          Acts::Once,
          makeEffect<FloorFriction>};
}

}  // namespace nao::sim
