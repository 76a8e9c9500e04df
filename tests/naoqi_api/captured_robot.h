#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/service_hub.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {

/// The two services of the server in the capture `nao_clients`, as number 2 and 3.
class CapturedRobot {
 public:
  CapturedRobot() : hub(DemoHub::options(rpc::Personality::libqi4(), {})) {
    hub.add(motion());
    hub.add(cameras());
  }

  /// The robot arrives.
  void endMoves() {
    for (const auto& move : std::exchange(moves_, {})) move.resolve();
  }

  rpc::ServiceHub hub;

 private:
  rpc::Service motion() {
    using rpc::Argument;
    const std::function<void()> nothing = [] {};
    return rpc::Service("ALMotion", "")
        .method("wakeUp", nothing, "")
        .method("moveInit", nothing, "")
        .method("waitUntilMoveIsFinished", nothing, "")
        .method("moveTo",
                std::function([this](float, float, float) { return moves_.emplace_back(); }), "",
                Argument{}, Argument{}, Argument{})
        .method("setAngles", std::function([](const Value&, const Value&, float) {}), "",
                Argument{}, Argument{}, Argument{})
        .method("getAngles", std::function([](const Value&, bool) {
                  return std::vector<float>{0.1F, 0.2F};
                }),
                "", Argument{}, Argument{});
  }

  static rpc::Service cameras() {
    using rpc::Argument;
    return rpc::Service("ALVideoDevice", "")
        .method("subscribeCamera", std::function([](const std::string& name, int, int, int, int) {
                  return name + "_0";
                }),
                "", Argument{}, Argument{}, Argument{}, Argument{}, Argument{})
        .method("unsubscribe", std::function([](const std::string&) { return true; }), "",
                Argument{})
        .method("getImageRemote", std::function([](const std::string&) { return image(); }), "",
                Argument{});
  }

  static Value image() {
    return Value::list(
        {4, 3, 3, 11, 1000, 2000, Value::raw(Bytes(36, 0x7F)), 0, 0.1F, 0.2F, 0.3F, 0.4F});
  }

  std::vector<rpc::Pending<void>> moves_;
};

}  // namespace nao::wire
