#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/robot_model.h"
#include "validation/play.h"
#include "validation/report.h"

namespace nao::validation {

/// A picture taken at `time` [s] of a motion, as a PNG.
struct Still {
  double time = 0;
  std::string png;
};

/// A motion that was played, as one HTML page that needs no other file: what was found, pictures,
/// how each joint followed. @throws InputError without gnuplot.
std::string playPage(const RobotModel& model, const Report& report, const Played& played,
                     const std::vector<Still>& stills);

}  // namespace nao::validation
