#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "naoqi_api/services/robot_services.h"
#include "tests/naoqi_api/services/robot_bench.h"
#include "tests/support/models.h"

namespace nao::services {

/// All services of a robot without physics: calls by service and method, in simulated time.
class ServicesBench : public testing::Test {
 protected:
  /// `data_dir`: the clients' files; none unless a test wants some.
  explicit ServicesBench(std::filesystem::path data_dir = {})
      : data_dir_(std::move(data_dir)),
        bench_(loadRobotModel(std::string(NAO_SOURCE_DIR) + "/robots", "nao_h25_v50")),
        services_(bench_.link, setup()),
        hub_({}) {
    services_.addTo(hub_);
    run(0.05);
  }

  void cycle() {
    bench_.cycle();
    services_.deliver();
  }
  void run(double seconds) {
    const int cycles = static_cast<int>(seconds / toSeconds(bench_.model->cycle) + 0.5);
    for (int i = 0; i < cycles; ++i) cycle();
  }

  rpc::Pending<rpc::Value> start(const std::string& service, const std::string& method,
                                 const std::vector<rpc::Value>& arguments = {}) {
    return hub_.findService(service)->call(method, arguments);
  }
  /// Lets the robot go on until the call ends: its value, or "! error".
  rpc::Value call(const std::string& service, const std::string& method,
                  const std::vector<rpc::Value>& arguments = {}) {
    const auto pending = start(service, method, arguments);
    for (int i = 0; i < 3000 && !pending.isDone(); ++i) cycle();
    EXPECT_TRUE(pending.isDone()) << service << "." << method << " did not end within 30 s";
    if (!pending.isDone()) return {};
    const auto& outcome = *pending.outcome();
    return outcome.error ? rpc::Value("! " + *outcome.error) : *outcome.value;
  }
  rpc::Value data(const std::string& key) { return call("ALMemory", "getData", {key}); }
  double number(const rpc::Value& value) { return value.findNumber().value_or(-1); }
  double now() const { return toSeconds(bench_.link.now()); }

  RobotServicesSetup setup() {
    RobotServicesSetup setup;
    setup.ports = bench_.ports;
    setup.images = images_;
    setup.robot_name = "nao";
    setup.data_dir = data_dir_;
    setup.log = [this](const std::string& text) { log_.push_back(text); };
    return setup;
  }

  std::filesystem::path data_dir_;
  std::shared_ptr<camera::ImageFeed> images_ = std::make_shared<camera::ImageFeed>();
  std::vector<std::string> log_;
  RobotBench bench_;
  RobotServices services_;
  rpc::ServiceHub hub_;
};

}  // namespace nao::services
