#include "recorder/quiet_robot.h"

#include <cstdio>
#include <exception>

#include "naoqi_api/call_error.h"

namespace nao::recorder {

using rpc::Value;

QuietRobot::QuietRobot(daemon::QiClient& client, const std::vector<std::string>& joints)
    : client_(client) {
  const Value names = Value::listOf("s", std::vector<Value>(joints.begin(), joints.end()));
  change("getFallManagerEnabled", {}, "setFallManagerEnabled", false);
  change("getCollisionProtectionEnabled", {"Arms"}, "setCollisionProtectionEnabled", false);
  change("getSmartStiffnessEnabled", {}, "setSmartStiffnessEnabled", false);
  change("getStiffnesses", {names}, "setStiffnesses", 1.0F);
}

// Asks for what is, then for what shall be.
void QuietRobot::change(const char* getter, const Arguments& which, const char* setter,
                        const Value& value) {
  Arguments before = which, now = which;
  try {
    before.push_back(client_.call("ALMotion", getter, which));
    now.push_back(value);
    client_.call("ALMotion", setter, now);
    undo_.insert(undo_.begin(), {setter, before});
  } catch (const rpc::CallError& error) {
    std::fprintf(stderr, "ALMotion.%s: %s\n", setter, error.what());
  }
}

QuietRobot::~QuietRobot() {
  for (const auto& [setter, before] : undo_) {
    try {
      client_.call("ALMotion", setter, before);
    } catch (const rpc::CallError& error) {
      std::fprintf(stderr, "ALMotion.%s: %s\n", setter, error.what());
    } catch (const std::exception& error) {
      std::fprintf(stderr, "the robot's settings stay as they are: %s\n", error.what());
      return;  // nobody listens any more
    }
  }
}

}  // namespace nao::recorder
