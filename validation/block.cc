#include "validation/block.h"

#include <cmath>

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

// About the middle of a box.
Mat3 boxInertia(double mass, const Vec3& size) {
  const Vec3 s = size.cwiseProduct(size);
  return (mass / 12 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal();
}

Body boxBody(const char* name, double mass, const Vec3& size, double center_z) {
  Body body;
  body.name = name;
  body.mass = mass;
  body.p_BoBcm = Vec3(0, 0, center_z);
  body.I_Bcm = boxInertia(mass, size);
  return body;
}

// An ideal motor, so strong that its torque limit does not matter.
Actuator strongMotor(double kp, double inertia) {
  Actuator motor;
  motor.name = "hinge";
  motor.coordinates = {0};
  motor.lower = -M_PI / 2;
  motor.upper = M_PI / 2;
  motor.max_velocity = 10;
  motor.max_torque = 1e4;
  motor.stall_torque = 1e4;
  motor.no_load_speed = 1e3;
  motor.efficiency = 1;
  motor.kp = kp;
  motor.kd = 2 * std::sqrt(kp * inertia);  // critically damped
  return motor;
}

}  // namespace

std::shared_ptr<const RobotModel> fallingBlock(double linear_damping) {
  auto model = std::make_shared<RobotModel>();
  model->name = "block";
  model->cycle = 10ms;
  model->bodies.push_back(boxBody("block", 1, Vec3::Constant(0.2), 0));
  if (linear_damping > 0) {
    model->effects.push_back({"linear_damping", {{"rate", linear_damping}}, {}, "gravity"});
  }
  return model;
}

std::shared_ptr<const RobotModel> BlockStack::model(Duration cycle) const {
  auto model = std::make_shared<RobotModel>();
  model->name = "stacked blocks";
  model->cycle = cycle;
  model->fixed_base = true;
  model->bodies.push_back(boxBody("bottom", mass, Vec3::Constant(edge), edge / 2));
  Body upper = boxBody("upper", 3 * mass, Vec3(edge, edge, 3 * edge), 1.5 * edge);
  upper.parent = 0;
  upper.X_PB = translation({0, 0, edge});
  upper.axis = Vec3::UnitY();
  model->coordinates.push_back({"hinge", toJoint(0), -M_PI / 2, M_PI / 2});
  const double about_hinge = upper.I_Bcm(1, 1) + upper.mass * std::pow(1.5 * edge, 2);
  model->bodies.push_back(upper);
  model->actuators.push_back(strongMotor(kp, about_hinge));
  return model;
}

double BlockStack::restAngle(double command, double gravity) const {
  const double torque = 3 * mass * gravity * 1.5 * edge;  // [N m] lying flat
  double angle = command;
  for (int i = 0; i < 50; ++i) {  // Newton; converges in a handful of steps
    const double error = kp * (command - angle) + torque * std::sin(angle);
    angle -= error / (torque * std::cos(angle) - kp);
  }
  return angle;
}

}  // namespace nao::validation
