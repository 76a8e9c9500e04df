#include "naoqi_api/services/version_shapes.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Personality;
using rpc::Value;

/// A robot of one NAOqi.
class Robot {
 public:
  explicit Robot(const std::string& naoqi)
      : bench_(loadRobotModel(std::string(NAO_SOURCE_DIR) + "/robots", "nao_h25_v50")),
        services_(bench_.link, setup(naoqi)),
        hub_({}) {
    services_.addTo(hub_);
    bench_.run(0.05);
  }
  const rpc::ServiceHub& hub() const { return hub_; }
  Value call(const std::string& service, const std::string& method,
             const std::vector<Value>& arguments = {}) {
    return bench_.call(*hub_.findService(service), method, arguments);
  }
  std::shared_ptr<rpc::Service> find(const std::string& service) {
    return hub_.findService(service);
  }

 private:
  RobotServicesSetup setup(const std::string& naoqi) {
    RobotServicesSetup setup;
    setup.ports = bench_.ports;
    setup.images = std::make_shared<camera::ImageFeed>();
    setup.personality = Personality::naoqi(naoqi);
    return setup;
  }
  RobotBench bench_;
  RobotServices services_;
  rpc::ServiceHub hub_;
};

bool has(Robot& robot, const std::string& service, const std::string& method) {
  const auto found = robot.find(service);
  if (!found) return false;
  const auto& methods = found->methods();
  return std::any_of(methods.begin(), methods.end(),
                     [&](const auto& entry) { return entry.second.name == method; });
}

TEST(VersionShapes, WhatCameLaterIsNotThere) {
  Robot oldest("1.12");
  Robot old("1.14");
  Robot later("2.1");
  EXPECT_FALSE(has(oldest, "ALMotion", "moveTo"));
  EXPECT_TRUE(has(oldest, "ALMotion", "walkTo"));
  EXPECT_FALSE(has(oldest, "ALRobotPosture", "goToPosture"));
  EXPECT_TRUE(has(old, "ALMotion", "moveTo"));
  EXPECT_TRUE(has(old, "ALRobotPosture", "goToPosture"));
  EXPECT_FALSE(has(old, "ALMotion", "setBreathEnabled"));
  EXPECT_FALSE(has(old, "ALTracker", "track"));
  EXPECT_TRUE(has(later, "ALMotion", "setBreathEnabled"));
  EXPECT_TRUE(has(later, "ALTracker", "track"));
}

TEST(VersionShapes, ARobotThatWasChosenAloneKeepsWhatCameLater) {
  EXPECT_TRUE(Personality::naoqi("1.14").hides_newer);
  EXPECT_FALSE(Personality::naoqiOf("V3.3").hides_newer);
}

std::size_t limitsOfHeadYaw(Robot& robot) {
  const Value limits = robot.call("ALMotion", "getLimits", {"HeadYaw"});
  return limits.findItems()->front().findItems()->size();
}

TEST(VersionShapes, TheFourthLimitCameWith114) {
  Robot old("1.12");
  Robot later("1.14");
  EXPECT_EQ(limitsOfHeadYaw(old), 3U);
  EXPECT_EQ(limitsOfHeadYaw(later), 4U);
}

TEST(VersionShapes, From28OnMovesTellTheirSuccess) {
  Robot before("2.5");
  Robot since("2.8");
  EXPECT_TRUE(before.call("ALMotion", "wakeUp").isVoid());
  EXPECT_EQ(since.call("ALMotion", "wakeUp"), Value(true));
}

// The wire encodes by what was read, clients decode by the text.
TEST(VersionShapes, TypesThatChangeChangeAsTextAndRead) {
  for (const char* version : {"1.12", "1.14", "2.1", "2.5", "2.8", "2.9"}) {
    const Robot robot(version);
    for (const auto& [id, entry] : robot.hub().entries()) {
      if (!entry.service) continue;
      for (const auto& [uid, method] : entry.service->methods()) {
        const std::string name = version + (" " + entry.service->name()) + "." + method.name;
        EXPECT_EQ(method.returns.text(), method.return_signature) << name;
        EXPECT_EQ(method.parameters.text(), method.parameters_signature) << name;
      }
    }
  }
}

TEST(VersionShapes, EveryServiceTellsTheVersion) {
  Robot robot("1.14.1");
  EXPECT_EQ(robot.call("ALMemory", "version"), Value("1.14.1"));
  EXPECT_EQ(robot.call("ALSystem", "systemVersion"), Value("1.14.1"));
}

TEST(VersionShapes, ARobotHasTheNaoqiThatRanOnIt) {
  EXPECT_EQ(Personality::naoqiOf("V3.3").release, 114);
  EXPECT_EQ(Personality::naoqiOf("V5.0").release, 201);
  EXPECT_EQ(Personality::naoqiOf("V6.0").release, 208);
  EXPECT_EQ(Personality::naoqiOf("").release, 201);
  EXPECT_THROW(Personality::naoqi("3.0"), InputError);
}

TEST(VersionShapes, TheWireOf29IsStrictAndAllOthersAreNot) {
  for (const char* version : {"1.12", "1.14", "2.1", "2.5", "2.8"}) {
    EXPECT_FALSE(Personality::naoqi(version).needs_authentication) << version;
    EXPECT_EQ(Personality::naoqi(version).service_info, ServiceInfoFields::Six) << version;
  }
  EXPECT_TRUE(Personality::naoqi("2.9").needs_authentication);
  EXPECT_EQ(Personality::naoqi("2.9").service_info, ServiceInfoFields::Seven);
  EXPECT_FALSE(Personality::naoqi("2.5").capabilities.at("ObjectPtrUID"));
}

TEST(VersionShapes, OneXNamesTheFirstWindowOfANameAsItWasAsked) {
  Robot old("1.14");
  Robot later("2.1");
  const std::vector<Value> window = {"eye", 1, 11, 5};
  EXPECT_EQ(old.call("ALVideoDevice", "subscribe", window), Value("eye"));
  EXPECT_EQ(old.call("ALVideoDevice", "subscribe", window), Value("eye_2"));
  EXPECT_EQ(later.call("ALVideoDevice", "subscribe", window), Value("eye_0"));
}

TEST(VersionShapes, TheRobotRequiresTheSoftwareItRuns) {
  Robot robot("2.8");
  EXPECT_EQ(robot.call("ALMemory", "getData", {"RobotConfig/Body/SoftwareRequirement"}),
            robot.call("ALSystem", "systemVersion"));
}

}  // namespace
}  // namespace nao::services
