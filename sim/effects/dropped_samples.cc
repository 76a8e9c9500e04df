// With this probability per cycle the readings of the joints do not arrive: the frame repeats those
// of the frame before. All joints of the effect miss the same frames, as on one bus.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class DroppedSamples final : public Effect {
 public:
  explicit DroppedSamples(const EffectSetup& setup)
      : joints_(setup.acting()),
        probability_(setup.value("probability")),
        random_(setup.random),
        angle_(joints_.size()),
        current_(joints_.size()) {}

  void alterSensors(SensorFrame& frame, Duration) override {
    const bool dropped = random_.uniform() < probability_ && begun_;
    begun_ = true;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& angle = frame.angle[joints_[i]];
      double& current = frame.current[joints_[i]];
      if (dropped) {
        angle = angle_[i];
        current = current_[i];
      }
      angle_[i] = angle;
      current_[i] = current;
    }
  }

  void archive(Archive& archive) override {
    archive.value(random_);
    archive.value(begun_);
    archive.list(angle_);
    archive.list(current_);
  }

 private:
  std::vector<std::size_t> joints_;
  double probability_;
  Random random_;
  bool begun_ = false;
  std::vector<double> angle_, current_;  // reported last
};

}  // namespace

EffectType droppedSamples() {
  return {"dropped_samples",
          "Now and then a reading does not arrive and the one before is repeated.",
          {{"probability", "", 0.02, 0, 0, 1, 0.002}},
          Acts::OnSensors,
          makeEffect<DroppedSamples>};
}

}  // namespace nao::sim
