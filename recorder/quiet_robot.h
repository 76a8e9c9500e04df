#pragma once

#include <string>
#include <utility>
#include <vector>

#include "daemon/qi_client.h"

namespace nao::recorder {

/// While it lives, nothing of the robot's own interferes with motions: fall manager, collision
/// protection of the arms and smart stiffness are off, and `joints` are stiff. At its end all of it
/// is as it was. What the robot refuses is told on standard error.
class QuietRobot {
 public:
  QuietRobot(daemon::QiClient& client, const std::vector<std::string>& joints);
  ~QuietRobot();
  QuietRobot(const QuietRobot&) = delete;
  QuietRobot& operator=(const QuietRobot&) = delete;

 private:
  using Arguments = std::vector<rpc::Value>;
  void change(const char* getter, const Arguments& which, const char* setter,
              const rpc::Value& value);

  daemon::QiClient& client_;
  std::vector<std::pair<const char*, Arguments>> undo_;  // calls of ALMotion, the last one first
};

}  // namespace nao::recorder
