#pragma once

#include <string>

#include "validation/play.h"
#include "validation/plot.h"
#include "validation/report.h"

namespace nao::validation {

/// The figures of a motion that was played; `name` is what the user called it.
Report reportPlay(const std::string& name, const motion::Timeline& timeline,
                  const PlaySettings& settings, const Played& played);

/// How the joints of one chain followed: asked and sensed angles by time, a panel each. A chain
/// is one of the model's "Chains"; empty if none of its joints moves.
Picture drawTracking(const RobotModel& model, const Played& played, const std::string& chain);

}  // namespace nao::validation
