#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "core/robot_model.h"
#include "motion/joint_set.h"
#include "naoqi_api/value.h"

namespace nao::services {

/// The joints that names stand for, in the order NaoQi lists them: a name is a joint, another name
/// of it (RHipYawPitch), or a group (Body, LArm, Joints). A joint may occur twice.
/// @throws CallError for a name that is neither.
std::vector<std::string> expandNames(const RobotModel& model,
                                     const std::vector<std::string>& names);
std::vector<Joint> jointsNamed(const RobotModel& model, const std::vector<std::string>& names);

/// @throws CallError if it is no number, or not finite.
double readNumber(const rpc::Value& value);

/// One name or a list of them. @throws CallError if it is something else.
std::vector<std::string> readNames(const rpc::Value& names);

/// What jointsNamed() says of a robot, looked up once.
class JointNames {
 public:
  explicit JointNames(const RobotModel& model);

  /// The joints of one name or of a list of names. @throws CallError
  std::vector<Joint> find(const rpc::Value& names) const;

 private:
  const RobotModel& model_;
  std::unordered_map<std::string, std::vector<Joint>> joints_;  // by every name there is
};

/// A joint's values and the times for them.
struct Course {
  Joint joint{};
  std::vector<double> values;
  std::vector<double> times;  // [s] ascending, positive; as many as values
};

/// Gives each joint its values and times from the shapes NaoQi takes: `values` and `times` are each
/// a number, a list of one number per joint, a list for the only joint, or a list of lists, one per
/// joint; a single time or list of times serves all joints. Of a joint named twice the first
/// counts, so LHipYawPitch wins over RHipYawPitch.
/// @throws CallError that says what does not fit.
std::vector<Course> spreadCourses(const RobotModel& model, const std::vector<std::string>& names,
                                  const rpc::Value& values, const rpc::Value& times);

/// One number per joint: a number for all, or a list of one each. @throws CallError.
std::vector<double> spreadNumbers(std::size_t joints, const rpc::Value& values);

/// A part of top speed: above 0; more than 1 counts as 1. @throws CallError.
double readFraction(double fraction);

}  // namespace nao::services
