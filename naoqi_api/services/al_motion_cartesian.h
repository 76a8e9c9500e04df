#pragma once

#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that moves the ends of chains: positions of six numbers (x, y, z [m], turns
/// about x, y, z [rad]) and transforms of 16 or 12 (rows of a matrix).
class AlMotionCartesian {
 public:
  explicit AlMotionCartesian(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  enum class Form { Position, Transform };

  void declareInterpolations(rpc::Service& service, Form form);
  void declareGoals(rpc::Service& service, Form form);

  template <Form form>
  rpc::Pending<void> interpolateOne(const std::string& chain, int space, const rpc::Value& path,
                                    int mask, const rpc::Value& times, bool is_absolute);
  template <Form form>
  rpc::Pending<void> interpolateAll(const std::vector<std::string>& chains, int space,
                                    const rpc::Value& paths, const rpc::Value& masks,
                                    const rpc::Value& times, bool is_absolute);
  template <Form form>
  rpc::Pending<void> interpolate(const rpc::Value& chains, const rpc::Value& spaces,
                                 const rpc::Value& paths, const rpc::Value& masks,
                                 const rpc::Value& times);
  template <Form form>
  void setOne(const std::string& chain, int space, const std::vector<float>& pose, float fraction,
              int mask);
  template <Form form>
  void changeOne(const std::string& chain, int space, const std::vector<float>& change,
                 float fraction, int mask);
  template <Form form>
  void setAll(const rpc::Value& chains, const rpc::Value& spaces, const rpc::Value& poses,
              float fraction, const rpc::Value& masks);

  RobotLink& link_;
};

}  // namespace nao::services
