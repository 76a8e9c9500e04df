#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/phase.h"

namespace nao::motion {

/// The families of postures are the places of a graph, the robot's ways (ways.yaml) its one-way
/// streets. Standing and Crouching are one place: a robot on its feet glides from one to the other.

/// The ways that lead from one family to another in the least time of keys; none if both are one
/// place, nothing if there is no such route.
std::optional<std::vector<const Way*>> findRoute(const RobotModel& model, const std::string& from,
                                                 const std::string& to);

/// A way from a family to itself, or null: how a robot makes room for the last glide, as one on
/// its belly does for its arms.
const Way* findWayAround(const RobotModel& model, const std::string& family);

/// Whether two families are one place of the graph.
bool areOnePlace(const std::string& a, const std::string& b);

/// A way's keys, one after the other. Fails, once the body has come to rest, if a key's pitch is
/// not met in time or the body is not in the way's family at its end. `way` must outlive the phase.
std::unique_ptr<Phase> follow(const Way& way);

}  // namespace nao::motion
