#include "naoqi_api/services/al_motion_footsteps.h"

#include <algorithm>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

// Step periods of control-walk 1.14 and 2.1 [s].
constexpr double kSlowest = 0.6;
constexpr double kFastest = 0.42;

std::vector<motion::StepOrder> readSteps(const std::vector<std::string>& legs,
                                         const rpc::Value& steps, std::size_t periods) {
  const auto places = steps.to<std::vector<std::vector<double>>>();
  if (legs.empty() || places.size() != legs.size() || periods != legs.size()) {
    throw rpc::CallError("expected as many steps and times as legs, got " +
                         std::to_string(places.size()) + " and " + std::to_string(periods) +
                         " for " + std::to_string(legs.size()));
  }
  std::vector<motion::StepOrder> orders;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i] != "LLeg" && legs[i] != "RLeg") {
      throw rpc::CallError("unknown leg " + legs[i] + ": expected LLeg or RLeg");
    }
    const std::vector<double>& place = places[i];
    if (place.size() != 3) throw rpc::CallError("expected a step [x, y, theta]");
    orders.push_back({legs[i] == "LLeg" ? Foot::Left : Foot::Right,
                      {finite(place[0]), finite(place[1]), finite(place[2])},
                      0});
  }
  return orders;
}

}  // namespace

void AlMotionFootsteps::declare(rpc::Service& service) {
  using Self = AlMotionFootsteps;
  const Argument legs{"legName", "LLeg or RLeg, one per step."};
  const Argument steps{"footSteps", "[x, y, theta] of each step, from the other foot."};
  const Argument clear{"clearExisting", "True: steps that may still change are forgotten."};
  addMethod(service, "setFootSteps", this, &Self::setFootSteps, "Takes these steps; does not wait.",
            legs, steps, Argument{"timeList", "When each step ends [s], ascending."}, clear)
      .at(167);
  addMethod(service, "setFootStepsWithSpeed", this, &Self::setFootStepsWithSpeed,
            "Takes these steps and waits until the robot stands.", legs, steps,
            Argument{"fractionMaxSpeed", "Of each step, 0 to 1."}, clear)
      .at(168);
}

void AlMotionFootsteps::setFootSteps(const std::vector<std::string>& legs, const rpc::Value& steps,
                                     const std::vector<float>& times, bool clear) {
  motion::WalkSteps request{readSteps(legs, steps, times.size()), clear, false};
  double before = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = finite(times[i]);
    if (time <= before) throw rpc::CallError("times must be positive and ascending");
    request.steps[i].period = time - before;
    before = time;
  }
  link_.post(std::move(request));
}

rpc::Pending<void> AlMotionFootsteps::setFootStepsWithSpeed(const std::vector<std::string>& legs,
                                                            const rpc::Value& steps,
                                                            const std::vector<float>& fractions,
                                                            bool clear) {
  motion::WalkSteps request{readSteps(legs, steps, fractions.size()), clear, true};
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    const double fraction = std::clamp(finite(fractions[i]), 0.0, 1.0);
    request.steps[i].period = kSlowest + fraction * (kFastest - kSlowest);
  }
  return link_.postAndWait(std::move(request));
}

}  // namespace nao::services
