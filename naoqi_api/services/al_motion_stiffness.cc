#include "naoqi_api/services/al_motion_stiffness.h"

#include <algorithm>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

const rpc::Argument kNames{"names", "Name of a joint or chain, or a list of names."};

// Below 0 the motor is off; above 1 is all there is.
double readStiffness(double stiffness) { return stiffness < 0 ? -1 : std::min(stiffness, 1.0); }

}  // namespace

void AlMotionStiffness::declare(rpc::Service& service) {
  using Self = AlMotionStiffness;
  addMethod(service, "wakeUp", this, &Self::wakeUp,
            "Switches the motors on; a robot that crouches stands up.")
      .at(113);
  addMethod(service, "rest", this, &Self::rest,
            "Brings the robot to a safe pose and switches the motors off.")
      .at(114);
  addMethod(service, "rest", this, &Self::restChain, "Switches the motors of a chain off.",
            rpc::Argument{"chainName", "Name of the chain."})
      .at(115);
  addMethod(service, "robotIsWakeUp", this, &Self::robotIsWakeUp,
            "Whether the motors have been switched on by wakeUp.")
      .at(122);
  addMethod(service, "stiffnessInterpolation", this, &Self::stiffnessInterpolation,
            "Changes stiffness along straight lines and waits until it is done.", kNames,
            rpc::Argument{"stiffnessLists", "A stiffness, 0 to 1, a list, or a list per joint."},
            rpc::Argument{"timeLists", "A time [s], a list, or a list per joint."})
      .at(123);
  addMethod(service, "setStiffnesses", this, &Self::setStiffnesses, "Sets stiffness at once.",
            kNames, rpc::Argument{"stiffnesses", "A stiffness, 0 to 1, or one per joint."})
      .at(124);
  addMethod(service, "getStiffnesses", this, &Self::getStiffnesses, "The stiffness of joints.",
            rpc::Argument{"jointName", kNames.meaning})
      .at(126);
}

rpc::Pending<void> AlMotionStiffness::wakeUp() { return link_.postAndWait(motion::WakeUp{}); }

rpc::Pending<void> AlMotionStiffness::rest() { return link_.postAndWait(motion::Rest{}); }

void AlMotionStiffness::restChain(const std::string& chain) {
  motion::SetStiffness request;
  request.joints = jointsNamed(link_.model(), {chain});
  request.stiffness.assign(request.joints.size(), 0.0);
  link_.post(std::move(request));
}

rpc::Pending<bool> AlMotionStiffness::robotIsWakeUp() {
  return link_.whenSettled([this] { return link_.state()->awake; });
}

rpc::Pending<void> AlMotionStiffness::stiffnessInterpolation(const rpc::Value& names,
                                                             const rpc::Value& stiffnesses,
                                                             const rpc::Value& times) {
  motion::InterpolateStiffness request;
  for (Course& course : spreadCourses(link_.model(), readNames(names), stiffnesses, times)) {
    for (double& value : course.values) value = std::max(readStiffness(value), 0.0);
    request.tracks.push_back({course.joint, std::move(course.values), std::move(course.times)});
  }
  return link_.postAndWait(std::move(request));
}

void AlMotionStiffness::setStiffnesses(const rpc::Value& names, const rpc::Value& stiffnesses) {
  motion::SetStiffness request;
  request.joints = jointsNamed(link_.model(), readNames(names));
  request.stiffness = spreadNumbers(request.joints.size(), stiffnesses);
  for (double& value : request.stiffness) value = readStiffness(value);
  link_.post(std::move(request));
}

rpc::Pending<std::vector<float>> AlMotionStiffness::getStiffnesses(const rpc::Value& names) {
  const auto joints = jointsNamed(link_.model(), readNames(names));
  return link_.whenSettled([this, joints] {
    const auto state = link_.state();
    std::vector<float> values;
    for (const Joint joint : joints) {
      values.push_back(static_cast<float>(state->stiffness[joint]));
    }
    return values;
  });
}

}  // namespace nao::services
