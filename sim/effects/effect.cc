#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class PlanChange final : public Effect {
 public:
  explicit PlanChange(std::function<void(BodyPlan&)> change) : change_(std::move(change)) {}
  void alterPlan(BodyPlan& plan) override { change_(plan); }

 private:
  std::function<void(BodyPlan&)> change_;
};

}  // namespace

std::vector<std::size_t> EffectSetup::acting() const {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j]) found.push_back(j);
  }
  return found;
}

std::vector<std::size_t> EffectSetup::hinged() const {
  std::vector<std::size_t> found;
  for (const std::size_t j : acting()) {
    if (!model.actuators[j].coordinates.empty()) found.push_back(j);
  }
  return found;
}

std::vector<std::size_t> EffectSetup::bodies() const {
  std::vector<std::size_t> found;
  for (const std::size_t j : hinged()) {
    for (const int c : model.actuators[j].coordinates) {
      found.push_back(static_cast<std::size_t>(c) + 1);
    }
  }
  return found;
}

std::unique_ptr<Effect> changePlan(std::function<void(BodyPlan&)> change) {
  return std::make_unique<PlanChange>(std::move(change));
}

}  // namespace nao::sim
