#include "naoqi_api/services/system_services.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "motion/postures.h"
#include "naoqi_api/services/al_preferences.h"
#include "naoqi_api/services/log_services.h"
#include "naoqi_api/services/make_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/package_manager.h"
#include "naoqi_api/services/pose_names.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

// What ALMemory's RobotConfig keys say, by key.
std::map<std::string, std::string> robotConfig(const ServiceContext& context) {
  std::map<std::string, std::string> config;
  for (const auto& [key, entry] : context.store().entries()) {
    if (key.rfind("RobotConfig/", 0) != 0) continue;
    const std::string* text = entry.last.value.findText();
    config[key] = text ? *text : entry.last.value.print();
  }
  const auto body = config.find("RobotConfig/Body/Version");
  if (body != config.end()) config["RobotConfig/Head/Device/Micro/Version"] = body->second;
  return config;
}

ServicePointer makeRobotModel(const ServiceContext& context) {
  auto service = makeModule("ALRobotModel", "Which robot this is.");
  const RobotModel& model = context.link.model();
  const bool is_nao = model.feet.size() == 2;
  addFunction(
      *service, "getRobotType", [is_nao] { return std::string(is_nao ? "Nao" : "Robot"); },
      "Nao, or Robot for one of another kind.");
  addFunction(
      *service, "hasLegs", [is_nao] { return is_nao; }, "Whether it stands on two feet.");
  const bool has_hands = model.findJoint("LHand").has_value();
  addFunction(
      *service, "hasHands", [has_hands] { return has_hands; }, "Whether its hands move.");
  addFunction(
      *service, "hasArms", [arms = model.findJoint("LShoulderPitch").has_value()] { return arms; },
      "Whether it has arms.");
  addFunction(
      *service, "_hasTouchSensorInHands", [has_hands] { return has_hands; },
      "Whether its hands feel touch.");
  addFunction(
      *service, "_getMicrophoneConfig", [] { return 0; }, "0: four microphones, as on a Nao.");
  addFunction(
      *service, "_getConfigMap", [context] { return robotConfig(context); },
      "The keys RobotConfig/... and their values.");
  addFunction(
      *service, "getConfig",
      [context] {
        std::string text;
        for (const auto& [key, value] : robotConfig(context)) text += key + "=" + value + "\n";
        return text;
      },
      "The keys RobotConfig/... and their values, one a line.");
  return service;
}

ServicePointer makeRobotPose(const ServiceContext& context) {
  auto service = makeModule("ALRobotPose", "How the robot stands or lies, by the names of 1.x.");
  RobotLink& link = context.link;
  const auto began = std::make_shared<std::pair<std::string, double>>("", 0);  // pose, since [s]
  const auto pose = [&link, began] {
    const std::string name = poseOf(motion::currentFamily(link.model(), *link.sensors()));
    const double now = toSeconds(link.now());
    if (began->first != name) *began = {name, now};
    return Value::list({name, static_cast<float>(now - began->second)});
  };
  addFunction(*service, "getActualPoseAndTime", pose,
              "[pose, for how many seconds it has been seen so].");
  addFunction(
      *service, "getPoseNames",
      [] {
        std::vector<Value> names = {"Unknown"};
        for (const auto& [family, name] : poseNames()) {
          if (std::find(names.begin(), names.end(), Value(name)) == names.end()) {
            names.emplace_back(name);
          }
        }
        return Value::list(std::move(names));
      },
      "The names of the poses.");
  return service;
}

std::vector<std::string> serviceNames(const rpc::ServiceHub& hub) {
  std::vector<std::string> names;
  for (const auto& [id, entry] : hub.entries()) {
    if (entry.ready) names.push_back(entry.name);
  }
  return names;
}

ServicePointer makeLauncher(const rpc::ServiceHub& hub) {
  auto service = makeModule("ALLauncher", "Which modules there are; none is ever launched.");
  addFunction(
      *service, "getGlobalModuleList", [&hub] { return serviceNames(hub); },
      "The names of all services.");
  addFunction(
      *service, "isModulePresent",
      [&hub](const std::string& name) { return hub.find(std::string_view(name)) != nullptr; },
      "Whether there is a service of this name.", Argument{"moduleName", "Its name."});
  return service;
}

ServicePointer makeServiceManager(const rpc::ServiceHub& hub) {
  auto service = makeModule("ALServiceManager", "Which services there are; all of them run.");
  const Argument name{"service", "Its name."};
  addFunction(
      *service, "services",
      [&hub] {
        std::vector<Value> list;
        for (const std::string& one : serviceNames(hub)) list.emplace_back(one);
        return Value::list(std::move(list));
      },
      "The names of all services.");
  const auto runs = [&hub](const std::string& one) {
    return hub.find(std::string_view(one)) != nullptr;
  };
  addFunction(*service, "isServiceRunning", runs, "Whether there is a service of this name.", name);
  for (const char* verb : {"startService", "restartService"}) {
    addFunction(*service, verb, runs, "Whether it runs; nothing is started.", name)
        .answering(rpc::Answer::Simplified);
  }
  addFunction(
      *service, "stopService", [](const std::string&) { return false; },
      "False: services of the robot do not stop.", name)
      .answering(rpc::Answer::Simplified);
  return service;
}

}  // namespace

std::vector<ServicePointer> makeSystemServices(const ServiceContext& context,
                                               const std::shared_ptr<BehaviorRunner>& behaviors,
                                               const rpc::ServiceHub& hub) {
  std::vector<ServicePointer> services = {makeRobotModel(context), makeRobotPose(context),
                                          makeLauncher(hub), makeServiceManager(hub),
                                          makePackageManager(behaviors)};
  for (const auto& service : makePreferences(context)) services.push_back(service);
  for (const auto& service : makeLogServices(context)) services.push_back(service);
  return services;
}

}  // namespace nao::services
