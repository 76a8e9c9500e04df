#include "naoqi_api/services/al_motion_walk.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

const Argument kX{"x", "Forward [m], or [m/s]."};
const Argument kY{"y", "To the left [m], or [m/s]."};
const Argument kTheta{"theta", "Turn to the left [rad], or [rad/s]."};
const Argument kPartX{"x", "Part of the largest step forward, -1 to 1."};
const Argument kPartY{"y", "Part of the largest step to the left, -1 to 1."};
const Argument kPartTheta{"theta", "Part of the largest turn to the left, -1 to 1."};
const Argument kFrequency{"frequency", "Part of the highest step frequency, 0 to 1."};
const Argument kTime{
    "time", "How long the way is to take [s], for robots on wheels; steps take their own time."};
const Argument kConfig{"moveConfig", "[[name, value], ...], for instance [[\"MaxStepX\", 0.06]]."};
const Argument kPoints{"controlPoint",
                       "[x, y, theta] or a list of those, each as seen from the one before."};

}  // namespace

void AlMotionWalk::declare(rpc::Service& service) {
  declareVelocities(service);
  declareTargets(service);
  declareEnds(service);
  declareReadings(service);
}

void AlMotionWalk::declareVelocities(rpc::Service& service) {
  using Self = AlMotionWalk;
  const char* const move = "Walks at a velocity until told otherwise; does not wait.";
  addMethod(service, "move", this, &Self::move, move, kX, kY, kTheta).at(135);
  addMethod(service, "move", this, &Self::moveWith, move, kX, kY, kTheta, kConfig).at(136);
  const char* const toward = "Walks at parts of the top velocity until told otherwise.";
  addMethod(service, "moveToward", this, &Self::moveToward, toward, kPartX, kPartY, kPartTheta)
      .at(137);
  addMethod(service, "moveToward", this, &Self::moveTowardWith, toward, kPartX, kPartY, kPartTheta,
            kConfig)
      .at(138);
  addMethod(service, "setWalkTargetVelocity", this, &Self::setWalkTargetVelocity, toward, kPartX,
            kPartY, kPartTheta, kFrequency)
      .at(139);
  addMethod(service, "setWalkTargetVelocity", this, &Self::setWalkTargetVelocityWith, toward,
            kPartX, kPartY, kPartTheta, kFrequency, Argument{"feetGaitConfig", kConfig.meaning})
      .at(140);
  addMethod(service, "setWalkTargetVelocity", this, &Self::setWalkTargetVelocityWithBoth, toward,
            kPartX, kPartY, kPartTheta, kFrequency, Argument{"leftFootMoveConfig", kConfig.meaning},
            Argument{"rightFootMoveConfig", kConfig.meaning + " Both feet walk with the last."})
      .at(141);
}

void AlMotionWalk::declareTargets(rpc::Service& service) {
  using Self = AlMotionWalk;
  const char* const to = "Walks to a place given in the robot's frame and waits until it is there.";
  addMethod(service, "moveTo", this, &Self::moveTo, to, kX, kY, kTheta).at(143);
  addMethod(service, "moveTo", this, &Self::moveToIn, to, kX, kY, kTheta, kTime).at(144);
  addMethod(service, "moveTo", this, &Self::moveToWith, to, kX, kY, kTheta, kConfig).at(145);
  addMethod(service, "moveTo", this, &Self::moveToInWith, to, kX, kY, kTheta, kTime, kConfig)
      .at(146);
  addMethod(service, "moveTo", this, &Self::movePath, to, kPoints).at(147);
  addMethod(service, "moveTo", this, &Self::movePathWith, to, kPoints, kConfig).at(148);
  addMethod(service, "walkTo", this, &Self::moveTo, to, kX, kY, kTheta).at(163);
  addMethod(service, "walkTo", this, &Self::moveToWith, to, kX, kY, kTheta, kConfig).at(164);
  addMethod(service, "walkTo", this, &Self::movePath, to, kPoints).at(165);
  addMethod(service, "walkTo", this, &Self::movePathWith, to, kPoints, kConfig).at(166);
}

void AlMotionWalk::declareEnds(rpc::Service& service) {
  using Self = AlMotionWalk;
  const char* const init = "Takes the pose from which a walk starts and waits until it is taken.";
  addMethod(service, "walkInit", this, &Self::moveInit, init).at(170);
  addMethod(service, "moveInit", this, &Self::moveInit, init).at(171);
  const char* const wait = "Waits until the robot stands.";
  addMethod(service, "waitUntilWalkIsFinished", this, &Self::waitUntilMoveIsFinished, wait).at(172);
  addMethod(service, "waitUntilMoveIsFinished", this, &Self::waitUntilMoveIsFinished, wait).at(173);
  const char* const active = "Whether the robot walks.";
  addMethod(service, "walkIsActive", this, &Self::moveIsActive, active).at(174);
  addMethod(service, "moveIsActive", this, &Self::moveIsActive, active).at(175);
  const char* const stop = "Ends the walk with both feet on the ground and waits until it stands.";
  addMethod(service, "stopWalk", this, &Self::stopMove, stop).at(176);
  addMethod(service, "stopMove", this, &Self::stopMove, stop).at(177);
  const char* const kill = "Ends the walk at once, wherever the feet are; the robot may fall.";
  addMethod(service, "killWalk", this, &Self::killMove, kill).at(288);
  addMethod(service, "killMove", this, &Self::killMove, kill).at(289);
}

void AlMotionWalk::declareReadings(rpc::Service& service) {
  using Self = AlMotionWalk;
  const char* const config = "The ranges or defaults of the move configuration.";
  const Argument which{"config", "Max, Min or Default."};
  addMethod(service, "getFootGaitConfig", this, &Self::getMoveConfig, config, which).at(178);
  addMethod(service, "getMoveConfig", this, &Self::getMoveConfig, config, which).at(179);
  addMethod(service, "getRobotPosition", this, &Self::getRobotPosition,
            "Where odometry has the robot: x, y [m], theta [rad].",
            Argument{"useSensors", "Either way the position is that of the steps commanded."})
      .at(180);
  addMethod(service, "getNextRobotPosition", this, &Self::getNextRobotPosition,
            "Where the robot will be after the steps that can no longer change.")
      .at(181);
  addMethod(service, "getRobotVelocity", this, &Self::getRobotVelocity,
            "The velocity of the walk: x, y [m/s], theta [rad/s].")
      .at(183);
  addMethod(service, "getFootSteps", this, &Self::getFootSteps,
            "[[left foot, right foot], [steps that can not change], [steps that can]]; a foot is "
            "[x, y, theta], a step [leg, seconds to go, [x, y, theta]].")
      .at(169);
}

}  // namespace nao::services
