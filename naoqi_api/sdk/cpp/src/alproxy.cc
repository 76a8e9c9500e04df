#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodulecore.h>
#include <alcommon/alproxy.h>

#include <boost/make_shared.hpp>
#include <memory>

#include "naoqi_api/call_error.h"
#include "naoqi_api/sdk/cpp/src/addresses.h"
#include "naoqi_api/sdk/cpp/src/broker_inside.h"
#include "naoqi_api/sdk/cpp/src/session.h"
#include "naoqi_api/sdk/cpp/src/value_bridge.h"

namespace AL {

using nao::client::Session;

struct ALProxy::Link {
  std::shared_ptr<Session> session;
  std::string service;
};

namespace {

std::vector<nao::rpc::Value> wireValues(const std::vector<ALValue>& arguments) {
  std::vector<nao::rpc::Value> values;
  values.reserve(arguments.size());
  for (const ALValue& argument : arguments) values.push_back(nao::client::toWire(argument));
  return values;
}

void mustExist(Session& session, const std::string& service) {
  try {
    session.find(service);
  } catch (const nao::rpc::CallError&) {
    throw ALError("ALProxy", "ALProxy", "Can't find service: " + service);
  }
}

std::shared_ptr<Session> sessionTo(const std::string& ip, int port) {
  try {
    return Session::shared(nao::client::endpointFor(ip, port));
  } catch (const std::exception& error) {
    throw ALError("ALProxy", "ALProxy", error.what());
  }
}

std::shared_ptr<Session> sessionOf(const boost::shared_ptr<ALBroker>& broker) {
  if (!broker) throw ALError("ALProxy", "ALProxy", "expected a broker, found none");
  return broker->inside().session;
}

std::vector<ALValue> itemsOf(const ALValue& arguments) {
  return arguments.isValid() ? static_cast<std::vector<ALValue>>(arguments)
                             : std::vector<ALValue>();
}

}  // namespace

ALProxy::ALProxy(const std::string& name, const std::string& ip, int port)
    : link_(boost::make_shared<Link>(Link{sessionTo(ip, port), name})) {
  mustExist(*link_->session, name);
}

ALProxy::ALProxy(boost::shared_ptr<ALBroker> broker, const std::string& name)
    : link_(boost::make_shared<Link>(Link{sessionOf(broker), name})) {
  mustExist(*link_->session, name);
}

ALProxy::ALProxy(const std::string& name)
    : ALProxy(ALBrokerManager::getInstance()->getRandomBroker(), name) {}

ALProxy::ALProxy(boost::shared_ptr<ALBroker> /*broker*/, const std::string& name,
                 const std::string& ip, int port)
    : ALProxy(name, ip, port) {}

ALProxy::ALProxy(boost::shared_ptr<ALProxy> other) : link_(other->link_) {}

ALProxy::~ALProxy() = default;

ALValue ALProxy::callWith(const std::string& method, const std::vector<ALValue>& arguments) const {
  try {
    return nao::client::fromWire(
        link_->session->call(link_->service, method, wireValues(arguments)));
  } catch (const nao::rpc::CallError& error) {
    throw ALError::ofAnswer(link_->service, method, error.what());
  }
}

int ALProxy::postWith(const std::string& method, const std::vector<ALValue>& arguments) const {
  try {
    return link_->session->post(link_->service, method, wireValues(arguments));
  } catch (const nao::rpc::CallError& error) {
    throw ALError::ofAnswer(link_->service, method, error.what());
  }
}

void ALProxy::genericCall(const std::string& method, const ALValue& arguments,
                          ALValue& result) const {
  result = callWith(method, itemsOf(arguments));
}

int ALProxy::methodMissing(const std::string& method, const ALValue& arguments) const {
  return postWith(method, itemsOf(arguments));
}

const std::string& ALProxy::getModuleName() const { return link_->service; }

bool ALProxy::isLocal() const { return nao::client::isOwnRobotSet(); }

boost::shared_ptr<ALProxy> ALProxy::getGenericProxy() const {
  return boost::make_shared<ALProxy>(*this);
}

boost::shared_ptr<ALModuleCore> ALProxy::getModule() const {
  return boost::make_shared<ALModuleCore>(link_->service);
}

}  // namespace AL
