// A mechanical stop that moves with another joint: where that one's angle o is beyond `place`, the
// stop is further inside by `upper` (o - place) or `lower` (o - place); a negative slope moves it
// where o is below `place`. The other joint is findCoupledTo(). The model's own coupled limits
// stay: the narrowest counts. Source: shells that meet at the edge of a hull of both angles, as a
// Nao's ankle does: a line is what an edge of the hull is near any one place.
#include "sim/effects/coupled_stop.h"

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

enum class End { Lower, Upper };

// From the place on, as far as the whole range is closed.
void addStop(BodyPlan& plan, std::size_t j, End end, double slope, double place) {
  const std::optional<Joint> other = findCoupledTo(plan.model, toJoint(j));
  if (!other || slope == 0) return;
  const int first = plan.model.actuators[j].coordinates.front();
  const Coordinate& hinge = plan.model.coordinates[static_cast<std::size_t>(first)];
  const double range = hinge.upper - hinge.lower;
  CoupledLimit limit;
  limit.driver = *other;
  limit.limited = toJoint(j);
  limit.clip = false;
  limit.rows = {{place, hinge.lower, hinge.upper}};
  if (end == End::Upper) {
    limit.rows.push_back({place + range / slope, hinge.lower, hinge.lower});
  } else {
    limit.rows.push_back({place + range / slope, hinge.upper, hinge.upper});
  }
  if (slope < 0) std::swap(limit.rows[0], limit.rows[1]);
  plan.model.coupled_limits.push_back(std::move(limit));
}

}  // namespace

std::optional<Joint> findCoupledTo(const RobotModel& model, Joint joint) {
  for (const CoupledLimit& limit : model.coupled_limits) {
    if (limit.limited == joint) return limit.driver;
  }
  const auto& hinges = model.actuators[index(joint)].coordinates;
  if (hinges.empty()) return std::nullopt;
  const int parent = model.bodies[static_cast<std::size_t>(hinges.front()) + 1].parent;
  if (parent <= 0) return std::nullopt;
  return model.coordinates[static_cast<std::size_t>(parent) - 1].joint;
}

EffectType coupledStop() {
  return {"coupled_stop",
          "A stop of the joint moves inwards as the joint that it hangs on bends.",
          {{"upper", "rad/rad", 0.5, 0, -20, 20, 0.05},
           {"lower", "rad/rad", 0, 0, -20, 20, 0.05},
           {"place", "rad", 0, 0, -4, 4, 0.02}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([joints = setup.hinged(), values = setup.values](BodyPlan& plan) {
              for (const std::size_t j : joints) {
                addStop(plan, j, End::Upper, values.at("upper"), values.at("place"));
                addStop(plan, j, End::Lower, values.at("lower"), values.at("place"));
              }
            });
          }};
}

}  // namespace nao::sim
