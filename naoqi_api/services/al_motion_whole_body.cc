#include "naoqi_api/services/al_motion_whole_body.h"

#include <cmath>

#include "motion/kinematics.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

// Free: the centre of mass goes over a foot in this time at full speed, without overshoot.
constexpr double kQuickest = 0.5;  // [s]

// Free: quick enough for a ball, slow enough that a camera image stays sharp.
constexpr double kTrackerFraction = 0.3;  // of the head's top speed

motion::Feet readFeet(const std::string& name) {
  if (name == "Legs") return motion::Feet::Both;
  if (name == "LLeg") return motion::Feet::Left;
  if (name == "RLeg") return motion::Feet::Right;
  throw rpc::CallError("unknown support " + name + ": expected Legs, LLeg or RLeg");
}

motion::FootState readState(const std::string& name) {
  if (name == "Fixed") return motion::FootState::Fixed;
  if (name == "Plane") return motion::FootState::Plane;
  if (name == "Free") return motion::FootState::Free;
  throw rpc::CallError("unknown foot state " + name + ": expected Fixed, Plane or Free");
}

void checkEffector(const RobotModel& model, const std::string& name) {
  const bool known = name == "Head" || name == "LArm" || name == "RArm";
  if (!known || !motion::findChain(model, name)) {
    throw rpc::CallError("unknown effector " + name + ": expected Head, LArm or RArm");
  }
}

void checkFeet(const RobotModel& model) {
  if (model.feet.size() != 2) throw rpc::CallError("this robot has no two feet to stand on");
}

}  // namespace

void AlMotionWholeBody::declare(rpc::Service& service) {
  using Self = AlMotionWholeBody;
  const Argument feet{"supportLeg", "Legs, LLeg or RLeg."};
  const Argument chain{"effectorName", "Head, LArm or RArm."};
  const Argument on{"isEnabled", "True: on, false: off."};
  addMethod(service, "wbEnable", this, &Self::wbEnable,
            "Lets the whole body carry out what joints are asked for.", on)
      .at(204);
  addMethod(service, "wbFootState", this, &Self::wbFootState, "How feet stand.",
            Argument{"stateName", "Fixed, Plane or Free."}, feet)
      .at(205);
  addMethod(service, "wbEnableBalanceConstraint", this, &Self::wbEnableBalanceConstraint,
            "Keeps the centre of mass over the feet.", on, feet)
      .at(206);
  addMethod(service, "wbGoToBalance", this, &Self::wbGoToBalance,
            "Brings the centre of mass over the feet and waits; true if it is there.", feet,
            Argument{"duration", "How long it is to take [s]."})
      .at(207);
  addMethod(service, "wbEnableEffectorControl", this, &Self::wbEnableEffectorControl,
            "Lets an effector be led by wbSetEffectorControl.", chain, on)
      .at(208);
  addMethod(service, "wbSetEffectorControl", this, &Self::wbSetEffectorControl,
            "A new target for an effector; does not wait.", chain,
            Argument{"targetCoordinate",
                     "In the robot's frame: turns about x, y, z [rad] for Head, a place [m] for "
                     "an arm."})
      .at(209);
  addMethod(service, "wbEnableEffectorOptimization", this, &Self::wbEnableEffectorOptimization,
            "Lets an effector keep its place over the feet, however the body moves.", chain, on)
      .at(210);
  addMethod(service, "wbGoToBalanceWithSpeed", this, &Self::wbGoToBalanceWithSpeed,
            "As wbGoToBalance, at a part of full speed.", feet,
            Argument{"fractionMaxSpeed", "Part of the maximum speed, up to 1."});
  addMethod(service, "updateTrackerTarget", this, &Self::updateTrackerTarget,
            "Starts turning the head to a target and does not wait.",
            Argument{"pTargetPositionWy", "Turn about y in the robot's frame [rad]."},
            Argument{"pTargetPositionWz", "Turn about z in the robot's frame [rad]."},
            Argument{"pTimeSinceDetectionMs", "Age of the target [ms]; changes nothing."},
            Argument{"pUseOfWholeBody",
                     "True: as wbSetEffectorControl of an enabled Head, false: the head alone."})
      .at(270);
  declareInner(service);
}

void AlMotionWholeBody::wbEnable(bool on) {
  link_.post(motion::WbEnable{on});
  if (!on) asked_ = {};
  asked_.enabled = on;
}

void AlMotionWholeBody::wbFootState(const std::string& state, const std::string& feet) {
  checkFeet(link_.model());
  link_.post(motion::WbFootState{readState(state), readFeet(feet)});
  for (auto& [foot, known] : asked_.feet) {
    if (feet == "Legs" || feet == foot) known = state;
  }
}

void AlMotionWholeBody::wbEnableBalanceConstraint(bool on, const std::string& feet) {
  checkFeet(link_.model());
  link_.post(motion::WbBalance{on, readFeet(feet)});
  asked_.balance = on ? feet : "";
}

rpc::Pending<bool> AlMotionWholeBody::wbGoToBalance(const std::string& feet, float seconds) {
  checkFeet(link_.model());
  if (!(finite(seconds) > 0)) throw rpc::CallError("the duration must be above 0");
  const auto moved =
      link_.outcomeOf(link_.post(motion::WbGoToBalance{readFeet(feet), finite(seconds)}));
  rpc::Pending<bool> there;
  moved.whenDone([there](const auto& outcome) {
    if (outcome.isCanceled()) return there.cancelNow();
    there.resolve(outcome.value->kind == motion::MotionOutcome::Kind::Done);
  });
  there.onCancel(moved.canceler());
  return there;
}

rpc::Pending<bool> AlMotionWholeBody::wbGoToBalanceWithSpeed(const std::string& feet,
                                                             float fraction) {
  return wbGoToBalance(feet, static_cast<float>(kQuickest / readFraction(fraction)));
}

void AlMotionWholeBody::wbEnableEffectorControl(const std::string& chain, bool on) {
  checkEffector(link_.model(), chain);
  link_.post(motion::WbEffector{chain, on});
  asked_.controlled[chain] = on;
}

void AlMotionWholeBody::wbSetEffectorControl(const std::string& chain, const rpc::Value& target) {
  checkEffector(link_.model(), chain);
  const auto numbers = target.to<std::vector<double>>();
  if (numbers.size() != 3) {
    throw rpc::CallError("expected a target of 3 numbers, got " + target.print());
  }
  link_.post(motion::WbEffectorTarget{
      chain, Vec3(finite(numbers[0]), finite(numbers[1]), finite(numbers[2]))});
}

void AlMotionWholeBody::wbEnableEffectorOptimization(const std::string& chain, bool on) {
  // A leg or the torso keeps its place by its foot state: there is nothing more to allow.
  if (chain == "LLeg" || chain == "RLeg" || chain == "Torso") return;
  checkEffector(link_.model(), chain);
  link_.post(motion::WbOptimize{chain, on});
  asked_.optimized[chain] = on;
}

void AlMotionWholeBody::updateTrackerTarget(float wy, float wz, int /*age_ms*/, bool whole_body) {
  const Vec3 turn(0, finite(wy), finite(wz));
  if (whole_body) {
    link_.post(motion::WbEffectorTarget{"Head", turn});
  } else {
    lookAlong(rotationFromRpy(turn.x(), turn.y(), turn.z()) * Vec3::UnitX());
  }
}

void AlMotionWholeBody::lookAlong(const Vec3& direction_R) {
  const auto yaw = link_.model().findJoint("HeadYaw");
  const auto pitch = link_.model().findJoint("HeadPitch");
  if (!yaw || !pitch) throw rpc::CallError("this robot has no head to turn");
  motion::Kinematics body(link_.sharedModel());
  body.update(link_.state()->command.angle);
  const Vec3 direction = body.calcRobotFrame().linear() * direction_R;  // in the torso's frame
  const double level = std::hypot(direction.x(), direction.y());
  link_.post(motion::SetAngles{
      {*yaw, *pitch},
      {std::atan2(direction.y(), direction.x()), std::atan2(-direction.z(), level)},
      {kTrackerFraction, kTrackerFraction},
      false});
}

}  // namespace nao::services
