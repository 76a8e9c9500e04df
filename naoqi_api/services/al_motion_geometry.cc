#include "naoqi_api/services/al_motion_geometry.h"

#include <algorithm>

#include "motion/support_polygon.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

// NaoQi's numbers for the frames.
constexpr int kFrameTorso = 0;
constexpr int kFrameRobot = 2;

constexpr double kLifted =
    0.01;  // [m] free choice: a sole higher than the other by this is in the air
constexpr double kWeight = 1.0;  // [N] on a foot: above what its force sensors read in the air

void checkSpace(int space) {
  if (space < kFrameTorso || space > kFrameRobot) {
    throw rpc::CallError("unknown space " + std::to_string(space) +
                         ": 0 is the torso's, 1 the world's, 2 the robot's");
  }
}

motion::Effector effectorNamed(const RobotModel& model, const std::string& name) {
  auto place = motion::findEffector(model, name);
  // A hand's motor moves no link of the model: its place is the end of its arm.
  if (!place && (name == "LHand" || name == "RHand") && model.findJoint(name)) {
    place = motion::findEffector(model, name.substr(0, 1) + "Arm");
  }
  if (!place) throw rpc::CallError("unknown chain, joint or sensor name: " + name);
  return *place;
}

// The bodies that a name stands for: all of them, those a chain moves, or one.
std::vector<int> bodiesNamed(const RobotModel& model, const std::string& name) {
  std::vector<int> bodies;
  const auto group = model.groups.find(name);
  if (name == "Body" || name == "Com") {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) bodies.push_back(static_cast<int>(i));
  } else if (const auto body = model.findBody(name)) {
    bodies.push_back(*body);
  } else {
    const std::vector<std::string> names =
        group == model.groups.end() ? std::vector<std::string>{name} : group->second;
    for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
      const bool moves =
          std::find(names.begin(), names.end(), model.coordinates[i].name) != names.end();
      if (moves) bodies.push_back(static_cast<int>(i) + 1);
    }
  }
  if (bodies.empty()) throw rpc::CallError("unknown chain or joint name: " + name);
  return bodies;
}

}  // namespace

void AlMotionGeometry::declare(rpc::Service& service) {
  using Self = AlMotionGeometry;
  const rpc::Argument name{"name", "Name of a chain, joint, camera or other sensor."};
  const rpc::Argument space{"space", "0: torso, 1: world (odometry), 2: robot."};
  const rpc::Argument sensors{"useSensorValues", "True: measured joints, false: commanded."};
  addMethod(service, "getPosition", this, &Self::getPosition,
            "Where something is: x, y, z [m], then its turn about x, y, z [rad].", name, space,
            sensors)
      .at(195);
  addMethod(service, "getTransform", this, &Self::getTransform,
            "Where something is: a 4 by 4 matrix, row by row.", name, space, sensors)
      .at(202);
  addMethod(service, "getMass", this, &Self::getMass, "The mass [kg].",
            rpc::Argument{"pName", "Name of a body, chain or joint, or Body."})
      .at(263);
  addMethod(service, "getCOM", this, &Self::getCom, "The centre of mass: x, y, z [m].",
            rpc::Argument{"pName", "Name of a body, chain or joint, or Body."},
            rpc::Argument{"pSpace", space.meaning},
            rpc::Argument{"pUseSensorValues", sensors.meaning})
      .at(264);
  addMethod(
      service, "getSupportPolygon", this, &Self::getSupportPolygon,
      "The corners [x, y] [m] of the ground between the feet that stand, counter-clockwise: "
      "those that feel weight, or whose soles are lowest.",
      rpc::Argument{"pSpace", space.meaning},
      rpc::Argument{"pUseSensorValues", "True: measured joints and forces, false: commands."});
}

void AlMotionGeometry::update(bool use_sensors) {
  kinematics_.update(use_sensors ? link_.sensors()->angle : link_.state()->command.angle);
}

Pose AlMotionGeometry::poseOfTorsoIn(int space) const {
  if (space == kFrameTorso) return Pose::Identity();
  const Pose X_RT = kinematics_.calcRobotFrame().inverse();
  if (space == kFrameRobot) return X_RT;
  const Pose2 at = link_.state()->position;
  Pose X_WR = translation({at.x, at.y, 0});
  X_WR.linear() = rotationFromRpy(0, 0, at.theta);
  return X_WR * X_RT;
}

Pose AlMotionGeometry::calcPose(const motion::Effector& place, int space, bool use_sensors) {
  update(use_sensors);
  return poseOfTorsoIn(space) * kinematics_.calcPose(place);
}

rpc::Pending<std::vector<float>> AlMotionGeometry::getPosition(const std::string& name, int space,
                                                               bool use_sensors) {
  checkSpace(space);
  const auto place = effectorNamed(link_.model(), name);
  return link_.whenSettled([this, place, space, use_sensors] {
    const Pose pose = calcPose(place, space, use_sensors);
    const Vec3 rpy = rpyOf(pose.linear());
    std::vector<float> numbers;
    for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<float>(pose.translation()[i]));
    for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<float>(rpy[i]));
    return numbers;
  });
}

rpc::Pending<std::vector<float>> AlMotionGeometry::getTransform(const std::string& name, int space,
                                                                bool use_sensors) {
  checkSpace(space);
  const auto place = effectorNamed(link_.model(), name);
  return link_.whenSettled([this, place, space, use_sensors] {
    const Eigen::Matrix4d matrix = calcPose(place, space, use_sensors).matrix();
    std::vector<float> numbers;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        numbers.push_back(static_cast<float>(matrix(row, column)));
      }
    }
    return numbers;
  });
}

rpc::Pending<std::vector<float>> AlMotionGeometry::getCom(const std::string& name, int space,
                                                          bool use_sensors) {
  checkSpace(space);
  const auto bodies = bodiesNamed(link_.model(), name);
  return link_.whenSettled([this, bodies, space, use_sensors] {
    update(use_sensors);
    Vec3 moment = Vec3::Zero();
    double mass = 0;
    for (const int body : bodies) {
      const Body& part = link_.model().bodies[static_cast<std::size_t>(body)];
      moment += part.mass * (kinematics_.getPose(body) * part.p_BoBcm);
      mass += part.mass;
    }
    const Vec3 com_T = mass > 0 ? Vec3(moment / mass) : moment;
    const Vec3 com = poseOfTorsoIn(space) * com_T;
    return std::vector<float>{static_cast<float>(com.x()), static_cast<float>(com.y()),
                              static_cast<float>(com.z())};
  });
}

std::vector<std::size_t> AlMotionGeometry::standingFeet(bool use_sensors) const {
  const RobotModel& model = link_.model();
  std::vector<std::size_t> standing;
  for (std::size_t i = 0; i < model.feet.size() && i < 2; ++i) {
    const auto height = [&](std::size_t foot) {
      const FootModel& sole = model.feet[foot];
      return (poseOfTorsoIn(kFrameRobot) * kinematics_.calcPose({sole.body, sole.X_BS}))
          .translation()
          .z();
    };
    const std::size_t other = model.feet.size() == 2 ? 1 - i : i;
    const bool stands = use_sensors ? link_.sensors()->feet[i].total > kWeight
                                    : height(i) < height(other) + kLifted;
    if (stands) standing.push_back(i);
  }
  return standing;
}

rpc::Pending<std::vector<std::vector<float>>> AlMotionGeometry::getSupportPolygon(
    int space, bool use_sensors) {
  checkSpace(space);
  return link_.whenSettled([this, space, use_sensors] {
    update(use_sensors);
    motion::Polygon points;
    for (const std::size_t i : standingFeet(use_sensors)) {
      const FootModel& foot = link_.model().feet[i];
      const Pose X_FS = poseOfTorsoIn(space) * kinematics_.calcPose({foot.body, foot.X_BS});
      for (const auto& corner : foot.outline) {
        points.push_back((X_FS * Vec3(corner.x(), corner.y(), 0)).head<2>());
      }
    }
    std::vector<std::vector<float>> corners;
    for (const Eigen::Vector2d& corner : motion::calcHull(points)) {
      corners.push_back({static_cast<float>(corner.x()), static_cast<float>(corner.y())});
    }
    return corners;
  });
}

float AlMotionGeometry::getMass(const std::string& name) {
  double mass = 0;
  for (const int body : bodiesNamed(link_.model(), name)) {
    mass += link_.model().bodies[static_cast<std::size_t>(body)].mass;
  }
  return static_cast<float>(mass);
}

}  // namespace nao::services
