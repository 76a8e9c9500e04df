#include "tests/hidden/mujoco/mjcf.h"

#include <algorithm>
#include <sstream>

namespace nao::hidden {
namespace {

std::string text(const Vec3& v) {
  std::ostringstream out;
  out.precision(12);
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

// Limits answer within two steps and friction gives way by little: as hard as MuJoCo's own rule
// (time constant of two steps at least) allows.
constexpr double kHard = 2;  // [steps]

class Writer {
 public:
  Writer(const MujocoRobot& robot, const std::vector<Joint>& stopped, double step)
      : robot_(robot), stopped_(stopped), answer_(kHard * step) {
    out_.precision(12);
    out_ << "<mujoco><compiler angle='radian' boundmass='1e-9' boundinertia='1e-12'/>"
         << "<option timestep='" << step << "' integrator='Euler' solver='Newton' gravity='0 0 "
         << -robot.gravity << "'><flag contact='disable'/></option><worldbody>";
    writeBody(0);
    out_ << "</worldbody><tendon>";
    for (std::size_t j = 0; j < robot.joints.size(); ++j) writeLinkAngles(j);
    out_ << "</tendon><equality>";
    for (const MujocoJoint& motor : robot.joints) writeSharedMotor(motor);
    out_ << "</equality></mujoco>";
  }
  std::string xml() const { return out_.str(); }

 private:
  const MujocoJoint& motorOf(int coordinate) const {
    const auto c = static_cast<std::size_t>(coordinate);
    return robot_.joints[index(robot_.model.coordinates[c].joint)];
  }
  // The second hinge of a shared motor has no rotor of its own.
  bool hasRotor(int coordinate) const { return motorOf(coordinate).coordinates[0] == coordinate; }
  bool hasPlay(int coordinate) const {
    return hasRotor(coordinate) && motorOf(coordinate).play > 0;
  }

  void writeBody(int index) {
    const Body& body = robot_.model.bodies[static_cast<std::size_t>(index)];
    const Eigen::Quaterniond q(body.X_PB.linear());
    const std::string place = " pos='" + text(Vec3(body.X_PB.translation())) + "'";
    std::ostringstream turn;
    turn.precision(12);
    turn << " quat='" << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << "'";
    out_ << "<body" << place << turn.str() << ">";
    const bool play = index > 0 && hasPlay(index - 1);
    if (index > 0) writeRotor(index - 1, body);
    if (play) {
      // MuJoCo asks every body for a mass: a hundredth of a gram, its inertia is the armature.
      out_ << "<inertial pos='0 0 0' mass='1e-5' diaginertia='1e-9 1e-9 1e-9'/><body>";
      writePlay(index - 1, body);
    }
    writeInertia(body);
    for (std::size_t i = 0; i < robot_.model.bodies.size(); ++i) {
      if (robot_.model.bodies[i].parent == index) writeBody(static_cast<int>(i));
    }
    out_ << (play ? "</body></body>" : "</body>");
  }

  void writeInertia(const Body& body) {
    const Mat3& I = body.I_Bcm;
    out_ << "<inertial mass='" << body.mass << "' pos='" << text(body.p_BoBcm) << "' fullinertia='"
         << I(0, 0) << ' ' << I(1, 1) << ' ' << I(2, 2) << ' ' << I(0, 1) << ' ' << I(0, 2) << ' '
         << I(1, 2) << "'/>";
  }

  void writeRotor(int coordinate, const Body& body) {
    const MujocoJoint& motor = motorOf(coordinate);
    out_ << "<joint name='rotor" << coordinate << "' axis='" << text(body.axis) << "'";
    if (hasRotor(coordinate)) {
      out_ << " armature='" << motor.armature << "' damping='" << motor.damping
           << "' frictionloss='" << motor.friction_loss << "' solreffriction='" << answer_
           << " 1' solimpfriction='0.99 0.99 0.001'";
    }
    out_ << "/>";
  }

  void writePlay(int coordinate, const Body& body) {
    const double half = motorOf(coordinate).play / 2;
    out_ << "<joint name='play" << coordinate << "' axis='" << text(body.axis)
         << "' limited='true' range='" << -half << ' ' << half << "' solreflimit='" << answer_
         << " 1'/>";
  }

  void writeLinkAngle(int coordinate, bool stops) {
    out_ << "<fixed name='link" << coordinate << "'";
    if (stops) {
      const Coordinate& hinge = robot_.model.coordinates[static_cast<std::size_t>(coordinate)];
      out_ << " limited='true' range='" << hinge.lower << ' ' << hinge.upper << "' solreflimit='"
           << answer_ << " 1'";
    }
    out_ << "><joint joint='rotor" << coordinate << "' coef='1'/>";
    if (hasPlay(coordinate)) out_ << "<joint joint='play" << coordinate << "' coef='1'/>";
    out_ << "</fixed>";
  }

  void writeLinkAngles(std::size_t j) {
    const bool stops = std::find(stopped_.begin(), stopped_.end(), toJoint(j)) != stopped_.end();
    const std::vector<int>& coordinates = robot_.joints[j].coordinates;
    if (!stops && coordinates.size() < 2) return;
    for (const int c : coordinates) writeLinkAngle(c, stops);
  }

  void writeSharedMotor(const MujocoJoint& motor) {
    for (std::size_t i = 1; i < motor.coordinates.size(); ++i) {
      out_ << "<tendon tendon1='link" << motor.coordinates[0] << "' tendon2='link"
           << motor.coordinates[i] << "' solref='" << answer_ << " 1'/>";
    }
  }

  const MujocoRobot& robot_;
  const std::vector<Joint>& stopped_;
  double answer_;  // [s]
  std::ostringstream out_;
};

}  // namespace

std::string writeMjcf(const MujocoRobot& robot, const std::vector<Joint>& stopped, double step) {
  return Writer(robot, stopped, step).xml();
}

}  // namespace nao::hidden
