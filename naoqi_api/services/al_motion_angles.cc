#include "naoqi_api/services/al_motion_angles.h"

#include "naoqi_api/services/al_motion_bezier.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

const rpc::Argument kNames{"names", "Name of a joint or chain, or a list of names."};
const rpc::Argument kFraction{"fractionMaxSpeed", "Part of the maximum speed, up to 1."};
const rpc::Argument kKeys{"controlPoints",
                          "A list of keys per joint: an angle [rad], or [angle, [type, dTime, "
                          "dAngle], [type, dTime, dAngle]]."};

// One switch, or one per joint that all say the same: a motion is absolute or relative as a whole.
bool readAbsolute(const rpc::Value& value, std::size_t joints) {
  const bool is_list = value.isList();
  const auto switches = is_list ? value.to<std::vector<bool>>() : std::vector{value.to<bool>()};
  if (is_list && switches.size() != joints) {
    throw rpc::CallError("expected one isAbsolute per joint, got " +
                         std::to_string(switches.size()) + " for " + std::to_string(joints) +
                         " joints");
  }
  const bool first = !switches.empty() && switches.front();
  for (const bool one : switches) {
    if (one != first) throw rpc::CallError("joints must be all absolute or all relative");
  }
  return first;
}

}  // namespace

void AlMotionAngles::declare(rpc::Service& service) {
  using Self = AlMotionAngles;
  addMethod(service, "angleInterpolation", this, &Self::angleInterpolation,
            "Moves joints smoothly through angles at given times and waits until they are there.",
            kNames, rpc::Argument{"angleLists", "An angle [rad], a list, or a list per joint."},
            rpc::Argument{"timeLists", "A time [s], a list, or a list per joint."},
            rpc::Argument{"isAbsolute", "False: the angles are added to the present ones."})
      .at(127);
  addMethod(service, "angleInterpolationWithSpeed", this, &Self::angleInterpolationWithSpeed,
            "Moves joints to angles as fast as allowed and waits until they are there.", kNames,
            rpc::Argument{"targetAngles", "An angle [rad], or one per joint."},
            rpc::Argument{"maxSpeedFraction", kFraction.meaning})
      .at(128);
  addMethod(service, "angleInterpolationBezier", this, &Self::angleInterpolationBezier,
            "Moves joints along Bezier curves and waits until they are there.",
            rpc::Argument{"jointNames", "Names of the joints."},
            rpc::Argument{"times", "A list of times [s] per joint."}, kKeys)
      .at(129);
  addMethod(service, "setAngles", this, &Self::setAngles,
            "Starts moving joints to angles and does not wait.", kNames,
            rpc::Argument{"angles", "An angle [rad], or one per joint."}, kFraction)
      .at(130);
  addMethod(service, "setAngles", this, &Self::setAnglesWithSpeeds,
            "Starts moving joints to angles, each at its own speed, and does not wait.", kNames,
            rpc::Argument{"angles", "An angle [rad], or one per joint."},
            rpc::Argument{"fractionMaxSpeeds", "Part of the maximum speed, one per joint."});
  addMethod(service, "angleInterpolationWithSpeed", this, &Self::angleInterpolationWithSpeedTo,
            "The same as programs of NAOqi 1.x call it.", kNames,
            rpc::Argument{"targetAngles", "An angle [rad], or one per joint."},
            rpc::Argument{"maxSpeedFraction", kFraction.meaning},
            rpc::Argument{"isAbsolute", "True: no other way is there."});
  addMethod(service, "changeAngles", this, &Self::changeAngles,
            "Starts moving joints by these angles and does not wait.", kNames,
            rpc::Argument{"changes", "An angle [rad], or one per joint."}, kFraction)
      .at(131);
  addMethod(service, "getAngles", this, &Self::getAngles, "The angles of joints [rad].", kNames,
            rpc::Argument{"useSensors", "True: measured, false: commanded."})
      .at(132);
  addMethod(service, "openHand", this, &Self::openHand,
            "Opens a hand, waits until it is open, and switches its motor off.",
            rpc::Argument{"handName", "LHand or RHand."})
      .at(133);
  addMethod(service, "closeHand", this, &Self::closeHand,
            "Closes a hand, waits until it is closed, and switches its motor off.",
            rpc::Argument{"handName", "LHand or RHand."})
      .at(134);
  addMethod(
      service, "animation", this, &Self::animation,
      "Moves joints along Bezier curves, from where they are if relative, and waits.",
      rpc::Argument{"jointNames", "Names of the joints."},
      rpc::Argument{"times", "A list of times [s] per joint."}, kKeys,
      rpc::Argument{"isAbsolute",
                    "True, or false: the angles are added to the present ones; "
                    "or the same for each joint."},
      rpc::Argument{"supportSequence", "Empty: feet that carry the robot are not simulated."});
}

void AlMotionAngles::setAngles(const rpc::Value& names, const rpc::Value& angles, float fraction) {
  post(names, angles, {readFraction(fraction)}, false);
}

void AlMotionAngles::setAnglesWithSpeeds(const rpc::Value& names, const rpc::Value& angles,
                                         const std::vector<float>& fractions) {
  std::vector<double> read;
  for (const float fraction : fractions) read.push_back(readFraction(fraction));
  post(names, angles, std::move(read), false);
}

void AlMotionAngles::changeAngles(const rpc::Value& names, const rpc::Value& changes,
                                  float fraction) {
  post(names, changes, {readFraction(fraction)}, true);
}

void AlMotionAngles::post(const rpc::Value& names, const rpc::Value& angles,
                          std::vector<double> fractions, bool relative) {
  const auto joints = names_.find(names);
  const auto targets = spreadNumbers(joints.size(), angles);
  if (fractions.size() == 1) fractions.resize(joints.size(), fractions[0]);
  if (fractions.size() != joints.size()) {
    throw rpc::CallError("expected one fraction of maximum speed per joint");
  }
  motion::SetAngles request;
  request.relative = relative;
  motion::JointSet seen;  // LHipYawPitch wins over RHipYawPitch
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (seen.test(index(joints[i]))) continue;
    seen.set(index(joints[i]));
    request.joints.push_back(joints[i]);
    request.angles.push_back(targets[i]);
    request.fraction.push_back(fractions[i]);
  }
  link_.post(std::move(request));
}

rpc::Pending<std::vector<float>> AlMotionAngles::getAngles(const rpc::Value& names,
                                                           bool use_sensors) {
  const auto joints = names_.find(names);
  return link_.whenSettled([this, joints, use_sensors] {
    const auto sensors = use_sensors ? link_.sensors() : nullptr;
    const auto state = use_sensors ? nullptr : link_.state();
    const JointArray<double>& all = use_sensors ? sensors->angle : state->command.angle;
    std::vector<float> angles;
    angles.reserve(joints.size());
    for (const Joint joint : joints) angles.push_back(static_cast<float>(all[joint]));
    return angles;
  });
}

rpc::Pending<void> AlMotionAngles::angleInterpolation(const rpc::Value& names,
                                                      const rpc::Value& angles,
                                                      const rpc::Value& times, bool is_absolute) {
  motion::Interpolate request;
  request.relative = !is_absolute;
  for (const Course& course : spreadCourses(link_.model(), readNames(names), angles, times)) {
    motion::Curve curve;
    curve.joint = course.joint;
    for (std::size_t i = 0; i < course.values.size(); ++i) {
      motion::Key key;
      key.time = course.times[i];
      key.angle = course.values[i];
      curve.keys.push_back(key);
    }
    request.curves.push_back(std::move(curve));
  }
  return link_.postAndWait(std::move(request));
}

rpc::Pending<void> AlMotionAngles::angleInterpolationWithSpeed(const rpc::Value& names,
                                                               const rpc::Value& angles,
                                                               float fraction) {
  motion::InterpolateWithSpeed request;
  request.fraction = readFraction(fraction);
  const auto joints = names_.find(names);
  const auto targets = spreadNumbers(joints.size(), angles);
  motion::JointSet seen;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (seen.test(index(joints[i]))) continue;
    seen.set(index(joints[i]));
    request.joints.push_back(joints[i]);
    request.angles.push_back(targets[i]);
  }
  return link_.postAndWait(std::move(request));
}

rpc::Pending<void> AlMotionAngles::angleInterpolationWithSpeedTo(const rpc::Value& names,
                                                                 const rpc::Value& angles,
                                                                 float fraction, bool is_absolute) {
  if (!is_absolute) throw rpc::CallError("isAbsolute must be true: give the angles to go to");
  return angleInterpolationWithSpeed(names, angles, fraction);
}

rpc::Pending<void> AlMotionAngles::angleInterpolationBezier(const std::vector<std::string>& names,
                                                            const rpc::Value& times,
                                                            const rpc::Value& control_points) {
  motion::Interpolate request;
  request.smooth = false;
  request.curves =
      readBezierCurves(link_.model(), link_.state()->command.angle, names, times, control_points);
  return link_.postAndWait(std::move(request));
}

// Relative keys are curves from 0, which the engine moves to where the joint is.
rpc::Pending<void> AlMotionAngles::animation(const std::vector<std::string>& names,
                                             const rpc::Value& times,
                                             const rpc::Value& control_points,
                                             const rpc::Value& is_absolute,
                                             const rpc::Value& support_sequence) {
  const auto* steps = support_sequence.findItems();
  if (steps != nullptr && !steps->empty()) {
    throw rpc::CallError("a support sequence is not simulated: expected []");
  }
  const JointArray<double> here = link_.state()->command.angle;
  motion::Interpolate request;
  request.smooth = false;
  request.relative = !readAbsolute(is_absolute, names.size());
  request.curves = readBezierCurves(link_.model(), request.relative ? JointArray<double>{} : here,
                                    names, times, control_points);
  return link_.postAndWait(std::move(request));
}

rpc::Pending<void> AlMotionAngles::moveHand(const std::string& hand, double opening) {
  const auto joint = link_.model().findJoint(hand);
  if (!joint || !link_.model().actuators[index(*joint)].coordinates.empty()) {
    throw rpc::CallError("unknown hand name: " + hand);
  }
  link_.post(motion::SetStiffness{{*joint}, {1}});
  const auto moved = link_.postAndWait(motion::InterpolateWithSpeed{{*joint}, {opening}, 1});
  rpc::Pending<void> done;
  moved.whenDone([this, joint, done](const auto& outcome) {
    try {
      link_.post(motion::SetStiffness{{*joint}, {0}});
    } catch (const rpc::CallError& error) {
      return done.fail(error.what());
    }
    outcome.isCanceled() ? done.cancelNow() : done.resolve();
  });
  done.onCancel(moved.canceler());
  return done;
}

}  // namespace nao::services
