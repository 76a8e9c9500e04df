#include "tests/support/models.h"

namespace nao::test {
namespace {

Body solid(const std::string& name, double mass, const Vec3& com, const Vec3& inertia) {
  Body body;
  body.name = name;
  body.mass = mass;
  body.p_BoBcm = com;
  body.I_Bcm = inertia.asDiagonal();
  return body;
}

}  // namespace

std::shared_ptr<RobotModel> pendulum(double mass, double length) {
  auto model = std::make_shared<RobotModel>();
  model->name = "pendulum";
  model->cycle = std::chrono::milliseconds(10);
  model->fixed_base = true;
  model->bodies.push_back(solid("base", 1, Vec3::Zero(), Vec3::Constant(1e-3)));
  Body rod = solid("rod", mass, Vec3(length, 0, 0), Vec3::Constant(1e-6));
  rod.parent = 0;
  rod.axis = Vec3::UnitY();
  model->bodies.push_back(rod);
  model->coordinates.push_back({"hinge", toJoint(0), -10, 10});
  Actuator motor;
  motor.name = "hinge";
  motor.coordinates = {0};
  motor.lower = -10;
  motor.upper = 10;
  motor.max_velocity = 6;
  motor.max_torque = 3;
  motor.stall_torque = 8;
  motor.no_load_speed = 6;
  motor.kp = 150;
  motor.kd = 1.5;
  model->actuators.push_back(motor);
  return model;
}

std::shared_ptr<RobotModel> block(double mass, const Vec3& size) {
  auto model = std::make_shared<RobotModel>();
  model->name = "block";
  model->cycle = std::chrono::milliseconds(10);
  const Vec3 s = size.cwiseProduct(size);
  model->bodies.push_back(solid("block", mass, Vec3::Zero(),
                                mass / 12 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())));
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      model->contact_spheres.push_back({0, Vec3(x * size.x(), y * size.y(), -0.5 * size.z()), 0.0});
    }
  }
  return model;
}

std::shared_ptr<const RobotModel> robot(const std::string& name) {
  return loadRobotModel(NAO_SOURCE_DIR "/robots", name);
}

std::shared_ptr<WorldModel> flatWorld() {
  auto world = std::make_shared<WorldModel>();
  world->name = "flat";
  return world;
}

}  // namespace nao::test
