#include <algorithm>
#include <cmath>

#include "motion/posture_family.h"
#include "naoqi_api/services/al_motion_inner.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::Value;

// A joint moves that turns faster than this; free, above what a held joint's encoder shows.
constexpr double kMoves = 0.02;  // [rad/s]
constexpr std::chrono::milliseconds kWatched{20};
constexpr double kRecovery = 1;  // [s]; free

}  // namespace

void AlMotionInner::declareMoving(rpc::Service& service) {
  const Argument sensors{"useSensors", "True: measured joints, false: commanded."};
  addFunction(
      service, "_getJointIsMoving", [this](bool sensed) { return getMoving(sensed, false); },
      "1 for each joint of Body that turns, else 0.", sensors)
      .at(301);
  addFunction(
      service, "_getChainIsMoving", [this](bool sensed) { return getMoving(sensed, true); },
      "1 for each of Chains that has a joint that turns, else 0.", sensors)
      .at(302);
}

// What has changed one cycle of NaoQi later.
rpc::Pending<std::vector<int>> AlMotionInner::getMoving(bool use_sensors, bool chains) {
  const auto read = [this, use_sensors] {
    return use_sensors ? link_.sensors()->angle : link_.state()->command.angle;
  };
  rpc::Pending<std::vector<int>> moving;
  moving.onlyWaits();
  link_.after(kWatched, [this, moving, read, chains, before = read()] {
    if (!moving.isDone()) moving.resolve(compare(before, read(), chains));
  });
  return moving;
}

std::vector<int> AlMotionInner::compare(const JointArray<double>& before,
                                        const JointArray<double>& after, bool chains) const {
  const auto moves = [&](Joint joint) {
    return std::abs(after[joint] - before[joint]) >
           kMoves * std::chrono::duration<double>(kWatched).count();
  };
  std::vector<int> moving;
  if (!chains) {
    for (const Joint joint : jointsNamed(link_.model(), {"Body"})) moving.push_back(moves(joint));
    return moving;
  }
  const auto all = link_.model().groups.find("Chains");
  if (all == link_.model().groups.end()) return moving;
  for (const std::string& chain : all->second) {
    const auto joints = jointsNamed(link_.model(), {chain});
    moving.push_back(std::any_of(joints.begin(), joints.end(), moves) ? 1 : 0);
  }
  return moving;
}

void AlMotionInner::declareOrders(rpc::Service& service) {
  const Argument chain{"chainName", "Name of the chain."};
  addFunction(
      service, "_isChainGoToOrInRest",
      [this](const std::string& name) {
        const auto joints = jointsNamed(link_.model(), {name});
        return link_.whenSettled([this, joints] {
          const auto state = link_.state();
          const auto limp = [&](Joint joint) { return state->stiffness[joint] <= 0; };
          const auto rests = [](const motion::Task& task) { return task.name == "rest"; };
          return std::any_of(state->tasks.begin(), state->tasks.end(), rests) ||
                 std::all_of(joints.begin(), joints.end(), limp);
        });
      },
      "Whether a chain is limp, or the robot goes to rest.", chain)
      .at(118);
  addFunction(
      service, "_relaxMotorsWhenSitting",
      [this] {
        if (motion::bodyFamily(link_.model(), *link_.sensors()) != "Sitting") return;
        const auto joints = jointsNamed(link_.model(), {"LLeg", "RLeg"});
        link_.post(motion::SetStiffness{joints, std::vector<double>(joints.size(), 0.0)});
      },
      "Switches the motors of the legs off if the robot sits.")
      .at(311);
  addFunction(
      service, "_resetMotionCommandModelToSensors",
      [this](const Value& names) {
        const auto joints = jointsNamed(link_.model(), readNames(names));
        std::vector<double> angles;
        for (const Joint joint : joints) angles.push_back(link_.sensors()->angle[joint]);
        link_.post(motion::SetAngles{joints, std::move(angles),
                                     std::vector<double>(joints.size(), 1.0), false});
      },
      "Commands joints to where they are measured to be.",
      Argument{"pName", "Name of a joint or chain, or a list of names."})
      .at(319);
}

void AlMotionInner::declareBalance(rpc::Service& service) {
  addFunction(
      service, "_fall",
      [this](float angle) {
        finite(angle);
        link_.post(motion::KillAll{});
        const auto joints = jointsNamed(link_.model(), {"Body"});
        link_.post(motion::SetStiffness{joints, std::vector<double>(joints.size(), 0.0)});
      },
      "Lets go: all motions end and all joints are limp, so that the robot falls the way it leans.",
      Argument{"pFallAngle", "Changes nothing."})
      .at(309)
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "_balanceRecovery",
      [this] {
        if (link_.model().feet.empty()) throw rpc::CallError("this robot has no feet");
        if (link_.state()->move_active) link_.post(motion::StopMove{});
        return link_.postAndWait(motion::WbGoToBalance{motion::Feet::Both, kRecovery});
      },
      "Ends a walk, brings the centre of mass over the middle of the feet, and waits until it is "
      "there.")
      .at(310)
      .answering(rpc::Answer::Simplified);
}

void AlMotionInner::declareLooking(rpc::Service& service) {
  addFunction(
      service, "_lookAt",
      [this](const std::vector<float>& target, int frame, float fraction) {
        lookAt(target, frame, fraction);
      },
      "Starts turning the head to a place and does not wait.",
      Argument{"pTargetPosition", "x, y, z [m]."},
      Argument{"pFrame", "0: torso, 1: world (odometry), 2: robot."},
      Argument{"pMaxSpeedFraction", "Part of the maximum speed, up to 1."})
      .at(273);
  const Argument speed{"pWithSpeed", "Either way the joints hold where they are commanded now."};
  addFunction(
      service, "_stopLookAt", [this](bool) { holdStill("Head"); }, "Ends _lookAt.", speed)
      .at(274);
  addFunction(
      service, "_stopPointAt",
      [this](bool) {
        holdStill("LArm");
        holdStill("RArm");
      },
      "Ends what arms do to point.", speed)
      .at(275);
  const Argument names{"pNames", "Names of joints."};
  const Argument angles{"pTargetPositions", "Their angles [rad], one each."};
  const auto follow = [this](const std::vector<std::string>& joints,
                             const std::vector<float>& targets, std::vector<double> fractions) {
    const auto found = jointsNamed(link_.model(), joints);
    if (found.size() != targets.size()) throw rpc::CallError("expected an angle for each joint");
    std::vector<double> wanted;
    for (const float target : targets) wanted.push_back(finite(target));
    if (fractions.size() != found.size()) throw rpc::CallError("expected a speed for each joint");
    link_.post(motion::SetAngles{found, std::move(wanted), std::move(fractions), false});
  };
  addFunction(
      service, "_trackerAnticipation",
      [follow](const std::vector<std::string>& joints, const std::vector<float>& targets, int, bool,
               bool) { follow(joints, targets, std::vector<double>(joints.size(), 0.3)); },
      "Starts turning joints to a target and does not wait.", names, angles,
      Argument{"pTimeSinceDetectionMs", "Age of the target [ms]; changes nothing."},
      Argument{"pUseOfWholeBody", "Changes nothing."}, Argument{"pIsPointAt", "Changes nothing."})
      .at(271)
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "_trackerWithSpeed",
      [follow](const std::vector<std::string>& joints, const std::vector<float>& targets,
               const std::vector<float>& speeds, bool, bool) {
        std::vector<double> fractions;
        for (const float part : speeds) fractions.push_back(readFraction(part));
        follow(joints, targets, std::move(fractions));
      },
      "Starts turning joints to a target and does not wait.", names, angles,
      Argument{"speeds", "Parts of the maximum speed, one each."},
      Argument{"wholeBody", "Changes nothing."}, Argument{"pointAt", "Changes nothing."})
      .at(272)
      .answering(rpc::Answer::Simplified);
}

void AlMotionInner::lookAt(const std::vector<float>& target, int frame, float fraction) {
  const auto yaw = link_.model().findJoint("HeadYaw");
  const auto pitch = link_.model().findJoint("HeadPitch");
  if (!yaw || !pitch) throw rpc::CallError("this robot has no head to turn");
  if (target.size() != 3) throw rpc::CallError("expected a place of 3 numbers");
  if (frame < 0 || frame > 2) throw rpc::CallError("unknown frame " + std::to_string(frame));
  Vec3 place(finite(target[0]), finite(target[1]), finite(target[2]));
  const Pose X_WT = torsoInWorld(false);
  if (frame == 1) place = X_WT.inverse() * place;
  if (frame == 2) place = kinematics_.calcRobotFrame() * place;
  const auto neck = motion::findEffector(link_.model(), "HeadYaw");
  if (neck) place -= kinematics_.calcPose(*neck).translation();
  const double part = readFraction(fraction);
  link_.post(motion::SetAngles{
      {*yaw, *pitch},
      {std::atan2(place.y(), place.x()), std::atan2(-place.z(), std::hypot(place.x(), place.y()))},
      {part, part},
      false});
}

// What interpolations have booked goes on.
void AlMotionInner::holdStill(const char* group) {
  const auto state = link_.state();
  motion::SetAngles hold;
  for (const Joint joint : jointsNamed(link_.model(), {group})) {
    hold.joints.push_back(joint);
    hold.angles.push_back(state->command.angle[joint]);
    hold.fraction.push_back(1);
  }
  link_.post(std::move(hold));
}

}  // namespace nao::services
