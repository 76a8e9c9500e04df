// The robot is never put down twice at the same place: x and y N(0, position), theta N(0, angle),
// drawn once per run. Source: a hand and a mark on the floor; sizes are estimates.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class StartPose final : public Effect {
 public:
  explicit StartPose(const EffectSetup& setup) {
    Random random = setup.random;
    offset_.x = setup.value("position") * random.normal();
    offset_.y = setup.value("position") * random.normal();
    offset_.theta = setup.value("angle") * random.normal();
  }

  void alterStart(Pose2& start) override {
    start.x += offset_.x;
    start.y += offset_.y;
    start.theta += offset_.theta;
  }

  void listDraw(std::map<std::string, double>& draw) const override {
    draw["x"] = offset_.x;
    draw["y"] = offset_.y;
    draw["theta"] = offset_.theta;
  }

 private:
  Pose2 offset_;
};

}  // namespace

EffectType startPose() {
  return {"start_pose",
          "The robot starts a little beside its place, drawn once per run.",
          {{"position", "m", 0.002, 0, 0, 1, 0.0005},
           {"angle", "rad", 0.5 * M_PI / 180, 0, 0, 1, 0.1 * M_PI / 180}},
          Acts::Once,
          makeEffect<StartPose>};
}

}  // namespace nao::sim
