#include <alcommon/albrokermanager.h>
#include <alcommon/altoolsmain.h>
#include <usarnaoqi_sdk/local_host.h>

#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/sdk/cpp/src/addresses.h"
#include "naoqi_api/sdk/cpp/src/memory_pointers.h"
#include "naoqi_api/sdk/cpp/src/process_signals.h"

namespace {

// Never destroyed: modules may be ended after static objects.
struct Host {
  UsarnaoqiTell tell = nullptr;
  std::string last_error;  // told once, not every cycle
};
Host& host() {
  static Host* the_host = new Host;
  return *the_host;
}

bool create(const UsarnaoqiRobot& robot, const char* name, TMainType create_module) {
  const boost::shared_ptr<AL::ALBroker> broker =
      AL::ALBroker::createBroker(name, robot.host, 0, robot.host, robot.port);
  AL::ALBrokerManager::getInstance()->addBroker(broker);
  const int failed = create_module(broker);
  if (failed != 0) host().tell("_createModule returned an error");
  return failed == 0;
}

}  // namespace

bool usarnaoqi_sdk_start(const UsarnaoqiRobot* robot, const char* name, void* create_module,
                         UsarnaoqiTell tell) {
  host().tell = tell;
  nao::client::setOwnRobot(
      {robot->host, static_cast<std::uint16_t>(robot->port), robot->user, robot->token});
  nao::client::setOwnPictures(robot->pictures);
  try {
    return create(*robot, name, reinterpret_cast<TMainType>(create_module));
  } catch (const std::exception& error) {
    tell(error.what());
    return false;
  }
}

void usarnaoqi_sdk_cycle() {
  std::vector<std::string> errors = nao::client::refreshMemoryPointers();
  for (std::string& error : nao::client::runCycle()) errors.push_back(std::move(error));
  for (const std::string& error : errors) {
    if (error != host().last_error && host().tell) host().tell(error.c_str());
    host().last_error = error;
  }
}

void usarnaoqi_sdk_stop() { AL::ALBrokerManager::getInstance()->killAllBroker(); }
