#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/motion_request.h"
#include "naoqi_api/value.h"

namespace nao::services {

/// The curves of an angleInterpolationBezier call. Per joint a list of times and a list of keys:
///   key    = angle | [angle] | [angle, handle] | [angle, handle, handle]
///   handle = [type, dTime, dAngle]    dTime <= 0 before the key, >= 0 after it
/// (types 0 constant, 1 linear, 2 Bezier, 3 automatic Bezier with its handle worked out already;
/// the order dTime, dAngle is that of 1,736 exported keys, the old manual has it the other way
/// round). A key without handles gets automatic ones. `present` are the commanded angles.
/// @throws CallError that says what does not fit.
std::vector<motion::Curve> readBezierCurves(const RobotModel& model,
                                            const JointArray<double>& present,
                                            const std::vector<std::string>& names,
                                            const rpc::Value& times, const rpc::Value& keys);

}  // namespace nao::services
