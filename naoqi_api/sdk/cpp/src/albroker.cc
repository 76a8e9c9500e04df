#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodule.h>

#include "naoqi_api/sdk/cpp/src/addresses.h"
#include "naoqi_api/sdk/cpp/src/broker_inside.h"

namespace AL {

using nao::client::Session;

boost::shared_ptr<ALBroker> ALBroker::createBroker(const std::string& name, const std::string& ip,
                                                   int port, const std::string& parent_ip,
                                                   int parent_port, int /*flags*/,
                                                   const std::string& /*path*/,
                                                   bool /*load_autoload*/) {
  return boost::shared_ptr<ALBroker>(new ALBroker(name, ip, port, parent_ip, parent_port));
}

ALBroker::ALBroker(const std::string& name, const std::string& ip, int port,
                   const std::string& parent_ip, int parent_port)
    : fBrokerManager(ALBrokerManager::getInstance()),
      name_(name),
      ip_(ip),
      port_(port),
      parent_ip_(parent_ip),
      parent_port_(parent_port) {
  const nao::client::Endpoint endpoint = nao::client::endpointFor(parent_ip, parent_port);
  try {
    inside_ = std::make_unique<Inside>(Session::shared(endpoint));
  } catch (const std::exception& error) {
    throw ALError("ALBroker", "createBroker", error.what());
  }
}

ALBroker::~ALBroker() { shutdown(); }

boost::shared_ptr<ALProxy> ALBroker::getProxy(const std::string& name) {
  return boost::shared_ptr<ALProxy>(new ALProxy(shared_from_this(), name));
}

bool ALBroker::isModulePresent(const std::string& name) {
  try {
    inside_->session->find(name);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

std::vector<std::string> ALBroker::getGlobalModuleList() {
  return getProxy("ALLauncher")->call<std::vector<std::string>>("getGlobalModuleList");
}

std::vector<std::string> ALBroker::getModuleList() const {
  std::vector<std::string> names;
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  for (const auto& module : inside_->modules) names.push_back(module.first);
  return names;
}

boost::shared_ptr<ALModule> ALBroker::getModuleByName(const std::string& name) const {
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  const auto found = inside_->modules.find(name);
  return found == inside_->modules.end() ? boost::shared_ptr<ALModule>() : found->second;
}

void ALBroker::addModule(const boost::shared_ptr<ALModule>& module) {
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  inside_->modules[module->getName()] = module;
}

// A module's destructor may call the robot, and this broker.
void ALBroker::shutdown() {
  std::map<std::string, boost::shared_ptr<ALModule>> modules;
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  modules.swap(inside_->modules);
}

bool ALBroker::isConnected() const { return inside_->session->isOpen(); }

}  // namespace AL
