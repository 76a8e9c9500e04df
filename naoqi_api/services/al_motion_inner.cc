#include "naoqi_api/services/al_motion_inner.h"

#include <algorithm>
#include <array>

#include "core/check.h"
#include "motion/support_polygon.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::Value;

constexpr double kNaoqiCycle = 0.02;  // [s] as getMotionCycleTime says
constexpr std::size_t kMostPostures = 1024;

struct Same {
  const char* name;
  std::uint32_t uid;
  const char* as;
  const char* parameters;    // of that one
  std::vector<Value> given;  // its arguments, if the client gives none
  const char* but = "";      // what is missing, of a method that is simplified
};

const rpc::Method& methodOf(const rpc::Service& service, const Same& same) {
  for (const auto& [uid, method] : service.methods()) {
    if (method.name == same.as && method.parameters_signature == same.parameters) return method;
  }
  NAO_CHECK(false);
  std::abort();
}

// Another name of a method, perhaps with its arguments given.
void addSame(rpc::Service& service, const Same& same) {
  rpc::Method method = methodOf(service, same);
  method.name = same.name;
  method.meaning = std::string("As ") + same.as + ". " + (*same.but ? same.but : method.meaning);
  if (*same.but) method.answer = rpc::Answer::Simplified;
  if (!same.given.empty()) {
    method.arguments.clear();
    method.parameters_signature = "()";
    method.call = [call = method.call, given = same.given](const rpc::Caller& caller,
                                                           const std::vector<Value>&) {
      return call(caller, given);
    };
  }
  service.add(std::move(method)).at(same.uid);
}

std::vector<float> matrixOf(const Pose& pose) {
  const Eigen::Matrix4d matrix = pose.matrix();
  std::vector<float> numbers;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      numbers.push_back(static_cast<float>(matrix(row, column)));
    }
  }
  return numbers;
}

std::vector<float> asFloats(const Vec3& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()),
          static_cast<float>(vector.z())};
}

std::vector<float> positionOf(const Pose& pose) {
  std::vector<float> numbers = asFloats(pose.translation());
  for (const float turn : asFloats(rpyOf(pose.linear()))) numbers.push_back(turn);
  return numbers;
}

}  // namespace

void AlMotionInner::declare(rpc::Service& service) {
  declareSame(service);
  declareBody(service);
  declareGround(service);
  declareMoving(service);
  declareOrders(service);
  declareBalance(service);
  declareLooking(service);
  declareKept(service);
}

void AlMotionInner::declareSame(rpc::Service& service) {
  const char* const no_pod = "A Nao has no charging pod to go to.";
  for (const Same& same :
       {Same{"_rest", 116, "rest", "(s)", {}},
        Same{"_shutdown", 117, "rest", "()", {}, "The robot's host goes on."},
        Same{"_setStiffnesses", 125, "setStiffnesses", "(mm)", {}},
        Same{"_setMpcWalkTargetVelocity", 142, "setWalkTargetVelocity", "(ffff)", {}},
        Same{"_moveToPod", 149, "moveTo", "(fff)", {}, no_pod},
        Same{"_moveToPod", 150, "moveTo", "(fffm)", {}, no_pod},
        Same{"_getStopMovePosition", 182, "getNextRobotPosition", "()", {}},
        Same{"_setPushRecoveryEnabled", 248, "setPushRecoveryEnabled", "(b)", {}},
        Same{"_getComWorld", 307, "getCOM", "(sib)", {"Body", 1, false}},
        Same{"_relax", 312, "rest", "(s)", {}}}) {
    addSame(service, same);
  }
}

Pose AlMotionInner::torsoInWorld(bool use_sensors) {
  kinematics_.update(use_sensors ? link_.sensors()->angle : link_.state()->command.angle);
  const Pose2 at = link_.state()->position;
  Pose X_WR = translation({at.x, at.y, 0});
  X_WR.linear() = rotationFromRpy(0, 0, at.theta);
  return X_WR * kinematics_.calcRobotFrame().inverse();
}

void AlMotionInner::declareBody(rpc::Service& service) {
  const Argument posture{"postureName", "Name of a posture."};
  addFunction(
      service, "_getMotionPosture",
      [this](const std::string& name) { return getMotionPosture(name); },
      "The angles of the joints of Body in a posture [rad].", posture)
      .at(120);
  addFunction(
      service, "_setMotionPosture",
      [this](const std::string& name, const std::vector<float>& angles) {
        return setMotionPosture(name, angles);
      },
      "Keeps the angles of a posture for _getMotionPosture until the daemon ends; false for one of "
      "the robot's own. goToPosture does not know it.",
      posture, Argument{"bodyAngles", "One for each joint of Body [rad]."})
      .at(119)
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "_getMotionPostureList",
      [this] {
        std::vector<std::string> names;
        for (const Posture& known : link_.model().postures) names.push_back(known.name);
        for (const auto& [kept, angles] : kept_postures_) names.push_back(kept);
        return names;
      },
      "The postures that _getMotionPosture knows.")
      .at(121);
  const Argument name{"name", "Name of a joint or chain, or Body."};
  addFunction(
      service, "_getFullLimits", [this](const std::string& of) { return getFullLimits(of); },
      "As getLimits, with the mechanical stops instead of what commands may be.", name)
      .at(258);
  addFunction(
      service, "_getMotionCycleNumber",
      [this] {
        const double cycles = toSeconds(link_.now().time_since_epoch()) / kNaoqiCycle;
        return static_cast<std::int32_t>(static_cast<std::int64_t>(cycles) & 0x7fffffff);
      },
      "How many cycles of getMotionCycleTime have passed.")
      .at(260);
  addFunction(
      service, "_getInertia", [this](const std::string& of) { return getInertia(of); },
      "The inertia of a link about its centre of mass, 3 by 3, row by row [kg m^2].",
      Argument{"pName", "Name of a link, or of the joint that moves it."})
      .at(266);
  addFunction(
      service, "_getWorldRotation",
      [this] { return asFloats(rpyOf(torsoInWorld(false).linear())); },
      "How the torso is turned in the world: about x, y, z [rad].")
      .at(308);
  addFunction(
      service, "_getRealTorsoInWorld",
      [this] {
        Pose torso = torsoInWorld(true);
        const auto sensors = link_.sensors();
        torso.linear() =
            rotationFromRpy(sensors->angle_x, sensors->angle_y, rpyOf(torso.linear()).z());
        return positionOf(torso);
      },
      "Where the torso is in the world by measured joints, leaning as the inertial unit says: "
      "x, y, z [m], then its turn about them [rad].")
      .at(298);
}

std::vector<float> AlMotionInner::getMotionPosture(const std::string& name) const {
  const auto kept = kept_postures_.find(name);
  if (kept != kept_postures_.end()) return kept->second;
  const Posture* found = link_.model().findPosture(name);
  if (!found) throw rpc::CallError("unknown posture name: " + name);
  std::vector<float> angles;
  for (const Joint joint : jointsNamed(link_.model(), {"Body"})) {
    angles.push_back(static_cast<float>(found->angle[joint]));
  }
  return angles;
}

bool AlMotionInner::setMotionPosture(const std::string& name, const std::vector<float>& angles) {
  if (name.empty() || link_.model().findPosture(name)) return false;
  const std::size_t joints = jointsNamed(link_.model(), {"Body"}).size();
  if (angles.size() != joints) {
    throw rpc::CallError("expected " + std::to_string(joints) + " angles, got " +
                         std::to_string(angles.size()));
  }
  for (const float angle : angles) finite(angle);
  if (kept_postures_.size() >= kMostPostures && kept_postures_.count(name) == 0) {
    throw rpc::CallError("too many postures");
  }
  kept_postures_[name] = angles;
  return true;
}

std::vector<float> AlMotionInner::getInertia(const std::string& name) const {
  const RobotModel& model = link_.model();
  auto body = model.findBody(name);
  for (std::size_t i = 0; i < model.coordinates.size() && !body; ++i) {
    if (model.coordinates[i].name == name) body = static_cast<int>(i) + 1;
  }
  if (!body) throw rpc::CallError("unknown link or joint name: " + name);
  const Mat3& inertia = model.bodies[static_cast<std::size_t>(*body)].I_Bcm;
  std::vector<float> numbers;
  for (int i = 0; i < 9; ++i) numbers.push_back(static_cast<float>(inertia(i / 3, i % 3)));
  return numbers;
}

Value AlMotionInner::getFullLimits(const std::string& name) const {
  const RobotModel& model = link_.model();
  std::vector<Value> limits;
  for (const Joint joint : jointsNamed(model, {name})) {
    const Actuator& actuator = model.actuators[index(joint)];
    double lower = actuator.lower;
    double upper = actuator.upper;
    if (!actuator.coordinates.empty()) {
      const auto& hinge = model.coordinates[static_cast<std::size_t>(actuator.coordinates[0])];
      lower = hinge.lower;
      upper = hinge.upper;
    }
    limits.push_back(Value::list({static_cast<float>(lower), static_cast<float>(upper),
                                  static_cast<float>(actuator.max_velocity),
                                  static_cast<float>(actuator.max_torque)}));
  }
  return Value::list(std::move(limits));
}

void AlMotionInner::declareGround(rpc::Service& service) {
  addFunction(
      service, "_getGroundPlaneTf",
      [this] { return matrixOf(torsoInWorld(true) * kinematics_.calcRobotFrame()); },
      "The ground under the feet in the world by measured joints: 4 by 4, row by row.")
      .at(296);
  addFunction(
      service, "_getNormalForceContact",
      [this] {
        const auto sensors = link_.sensors();
        std::vector<float> forces;
        for (std::size_t i = 0; i < link_.model().feet.size() && i < 2; ++i) {
          forces.push_back(static_cast<float>(sensors->feet[i].total));
        }
        return forces;
      },
      "What the left and the right sole feel [N].")
      .at(297);
  const auto polygon = [this, &service] {
    return service.call("getSupportPolygon", {1, false}, {});
  };
  const auto flat = [polygon](bool centre) {
    rpc::Pending<std::vector<float>> result;
    polygon().whenDone([result, centre](const auto& outcome) {
      if (!outcome.value) return result.fail(outcome.error.value_or("canceled"));
      motion::Polygon corners;
      std::vector<float> numbers;
      for (const auto& corner : outcome.value->template to<std::vector<std::vector<float>>>()) {
        corners.emplace_back(corner.at(0), corner.at(1));
        numbers.insert(numbers.end(), corner.begin(), corner.end());
      }
      if (!centre || corners.empty()) return result.resolve(numbers);
      const Eigen::Vector2d middle = motion::centreOf(corners);
      result.resolve({static_cast<float>(middle.x()), static_cast<float>(middle.y())});
    });
    return result;
  };
  addFunction(
      service, "_getSupportPolygon", [flat] { return flat(false); },
      "The corners of getSupportPolygon in the world: x, y, x, y, ... [m].")
      .at(305);
  addFunction(
      service, "_getSupportPolygonCenter", [flat] { return flat(true); },
      "The centre of getSupportPolygon in the world: x, y [m].")
      .at(306);
  const char* hull = "The corners [x, y] of what the robot covers of the floor, in its own frame.";
  addFunction(
      service, "_getRobotGroundConvexHull", [this] { return rpc::toValue(getGroundHull()); }, hull)
      .at(300);
  addFunction(
      service, "_getRobotGroundConvexHullDebug", [this] { return rpc::toValue(getGroundHull()); },
      hull)
      .at(299);
}

// Of the soles and of spheres about the collision solids.
std::vector<std::vector<float>> AlMotionInner::getGroundHull() {
  kinematics_.update(link_.sensors()->angle);
  const Pose X_RT = kinematics_.calcRobotFrame().inverse();
  motion::Polygon points;
  for (std::size_t body = 0; body < link_.model().bodies.size(); ++body) {
    for (const Shape& solid : link_.model().bodies[body].collisions) {
      const Pose X_RS = X_RT * kinematics_.getPose(static_cast<int>(body)) * solid.X_BS;
      const bool is_box = solid.kind == Shape::Kind::Box;
      const double half = solid.size.z() / 2;
      for (const double x : {-1, 1}) {
        for (const double y : {-1, 1}) {
          for (const double z : {-half, half}) {
            const Vec3 corner(x * solid.size.x() / (is_box ? 2 : 1),
                              y * (is_box ? solid.size.y() / 2 : solid.size.x()), z);
            points.push_back((X_RS * corner).head<2>());
          }
        }
      }
    }
  }
  for (const FootModel& foot : link_.model().feet) {
    const Pose X_RS = X_RT * kinematics_.calcPose({foot.body, foot.X_BS});
    for (const auto& corner : foot.outline) {
      points.push_back((X_RS * Vec3(corner.x(), corner.y(), 0)).head<2>());
    }
  }
  std::vector<std::vector<float>> corners;
  for (const Eigen::Vector2d& corner : motion::calcHull(points)) {
    corners.push_back({static_cast<float>(corner.x()), static_cast<float>(corner.y())});
  }
  return corners;
}

}  // namespace nao::services
