#pragma once

#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that tells of torques, and of what touches the ground. Nobody documents
/// these methods; they do what their names say, by sensors alone. I/O thread.
class AlMotionTouch {
 public:
  explicit AlMotionTouch(RobotLink& link) : link_(link), kinematics_(link.sharedModel()) {}
  void declare(rpc::Service& service);

 private:
  enum class Which { All, ButFeet };
  struct LowPoint {
    int body = 0;
    Vec3 p_T = Vec3::Zero();
    double depth = 0;  // [m] along down; minus infinity of a body without solids
  };

  std::vector<float> getTorques(const rpc::Value& names, bool use_sensors) const;
  double commandedTorque(Joint joint) const;  // [N m]
  double feltTorque(Joint joint) const;       // [N m]
  rpc::Value getLoadedSoles() const;
  rpc::Value getTouching(Which which);
  LowPoint lowestOf(int body, const Vec3& down) const;
  bool isFoot(int body) const;

  RobotLink& link_;
  motion::Kinematics kinematics_;
};

}  // namespace nao::services
