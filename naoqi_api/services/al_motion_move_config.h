#pragma once

#include <string>

#include "motion/gait.h"
#include "naoqi_api/value.h"

namespace nao::services {

/// A move configuration as clients write it, [["MaxStepX", 0.06], ["Frequency", 0.8]], applied to
/// `config`. Values beyond their range are brought into it. Names may carry a foot
/// ("LeftStepHeight"); both feet then take the value. @throws CallError for an unknown name or
/// another shape.
motion::GaitConfig readMoveConfig(const rpc::Value& pairs, motion::GaitConfig config = {});

/// "Max", "Min" or "Default" as getMoveConfig lists it. @throws CallError for another name.
rpc::Value listMoveConfig(const std::string& which);

}  // namespace nao::services
