#pragma once

#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/al_motion_names.h"

namespace nao::services {

/// The part of ALMotion that moves and reads joints.
class AlMotionAngles {
 public:
  explicit AlMotionAngles(RobotLink& link) : link_(link), names_(link.model()) {}
  void declare(rpc::Service& service);

 private:
  void setAngles(const rpc::Value& names, const rpc::Value& angles, float fraction);
  void setAnglesWithSpeeds(const rpc::Value& names, const rpc::Value& angles,
                           const std::vector<float>& fractions);
  void changeAngles(const rpc::Value& names, const rpc::Value& changes, float fraction);
  rpc::Pending<std::vector<float>> getAngles(const rpc::Value& names, bool use_sensors);
  rpc::Pending<void> angleInterpolation(const rpc::Value& names, const rpc::Value& angles,
                                        const rpc::Value& times, bool is_absolute);
  rpc::Pending<void> angleInterpolationWithSpeed(const rpc::Value& names, const rpc::Value& angles,
                                                 float fraction);
  /// As programs of the 1.x days call it.
  rpc::Pending<void> angleInterpolationWithSpeedTo(const rpc::Value& names,
                                                   const rpc::Value& angles, float fraction,
                                                   bool is_absolute);
  rpc::Pending<void> angleInterpolationBezier(const std::vector<std::string>& names,
                                              const rpc::Value& times,
                                              const rpc::Value& control_points);
  rpc::Pending<void> animation(const std::vector<std::string>& names, const rpc::Value& times,
                               const rpc::Value& control_points, const rpc::Value& is_absolute,
                               const rpc::Value& support_sequence);
  rpc::Pending<void> openHand(const std::string& hand) { return moveHand(hand, 1); }
  rpc::Pending<void> closeHand(const std::string& hand) { return moveHand(hand, 0); }

  void post(const rpc::Value& names, const rpc::Value& angles, std::vector<double> fractions,
            bool relative);
  rpc::Pending<void> moveHand(const std::string& hand, double opening);

  RobotLink& link_;
  JointNames names_;
};

}  // namespace nao::services
