#pragma once

#include <vector>

#include "core/robot_model.h"
#include "motion/cartesian.h"
#include "naoqi_api/value.h"

namespace nao::services {

/// A pose of 6 numbers, or of 12 or 16. @throws CallError for another count.
Pose readPosition(const std::vector<double>& numbers);
Pose readTransform(const std::vector<double>& numbers);
using ReadPose = Pose (*)(const std::vector<double>&);

/// The tracks of a Cartesian call. `chains` is a name or a list of them; `spaces` and `masks` a
/// number for all or one per chain; `paths` per chain a list of poses or one pose, for an only
/// chain also without the outer list; `times` likewise, a list also for all chains.
/// @throws CallError that says what does not fit.
std::vector<motion::PoseTrack> readTracks(const RobotModel& model, ReadPose read,
                                          const rpc::Value& chains, const rpc::Value& spaces,
                                          const rpc::Value& paths, const rpc::Value& masks,
                                          const rpc::Value& times);

}  // namespace nao::services
