#pragma once

#include <memory>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"
#include "validation/report.h"

namespace nao::validation {

struct ReplayOptions {
  int runs = 32;  // simulated per motion
  int jobs = 1;   // threads
};

/// `usarnaoqi replay`: the commands of a set's fit and select runs on the model, per joint: error
/// of the means, what noise explains of it, and measured beside simulated spread; of a robot on its
/// feet also its gait.
Report replaySet(const LogSet& set, std::shared_ptr<const RobotModel> model,
                 const ReplayOptions& options);

}  // namespace nao::validation
