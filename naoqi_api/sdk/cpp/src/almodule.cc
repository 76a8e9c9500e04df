#include <alcommon/albroker.h>
#include <alcommon/almodule.h>

#include <memory>

#include "naoqi_api/sdk/cpp/src/broker_inside.h"
#include "naoqi_api/sdk/cpp/src/hosted_object.h"
#include "naoqi_api/sdk/cpp/src/session.h"

namespace AL {
namespace {

thread_local int modules_in_making = 0;  // by createModule() on this thread

}  // namespace

using nao::client::HostedObject;
using nao::client::Session;

struct ALModule::Inside {
  boost::weak_ptr<ALBroker> broker;
  std::string broker_name;
  std::shared_ptr<Session> session;
  std::shared_ptr<HostedObject> object;
  std::uint32_t id = 0;       // of the service
  HostedObject::Method next;  // what the next BIND_METHOD binds

  void withdraw() {
    if (id == 0) return;
    try {
      session->withdraw(id);
    } catch (const std::exception&) {
      // The robot has gone, and the module with it.
    }
    id = 0;
  }
};

ALModule::ALModule(boost::shared_ptr<ALBroker> broker, const std::string& name)
    : ALModuleCore(name), inside_(new Inside) {
  if (!broker) throw ALERROR(name, "ALModule", "expected a broker, found none");
  inside_->broker = broker;
  inside_->broker_name = broker->getName();
  inside_->session = broker->inside().session;
  inside_->object = std::make_shared<HostedObject>(name);
  if (modules_in_making == 0) inside_->object->open();
  try {
    inside_->id = inside_->session->offer(name, inside_->object);
  } catch (const std::exception& error) {
    throw ALError::ofAnswer(name, "ALModule", error.what());
  }
}

ALModule::~ALModule() {
  inside_->object->open();  // whoever waits is told
  inside_->withdraw();
}

void ALModule::exit() { inside_->withdraw(); }

boost::shared_ptr<ALBroker> ALModule::getParentBroker() const { return inside_->broker.lock(); }

std::string ALModule::getBrokerName() const { return inside_->broker_name; }

void ALModule::setModuleDescription(const std::string& meaning) {
  inside_->object->describe(meaning);
}

void ALModule::functionName(const std::string& name, const std::string& /*module*/,
                            const std::string& meaning, int /*flags*/) {
  inside_->next = HostedObject::Method();
  inside_->next.name = name;
  inside_->next.meaning = meaning;
}

void ALModule::addParam(const std::string& name, const std::string& meaning) {
  inside_->next.arguments.emplace_back(name, meaning);
}

void ALModule::setReturn(const std::string& name, const std::string& meaning) {
  inside_->next.return_meaning = name + ": " + meaning;
}

void ALModule::bindFunctor(const detail::Functor& functor) {
  if (inside_->next.name.empty()) {
    throw ALERROR(getName(), "BIND_METHOD", "expected functionName() before it");
  }
  inside_->next.parameters = functor.parameters;
  inside_->next.returns = functor.returns;
  inside_->next.call = functor.call;
  inside_->object->add(inside_->next);
  inside_->next = HostedObject::Method();
}

ALModule::Making::Making() { ++modules_in_making; }

ALModule::Making::~Making() { --modules_in_making; }

void ALModule::Making::begin(const boost::shared_ptr<ALBroker>& broker,
                             const boost::shared_ptr<ALModule>& module) {
  module->inside_->object->open();
  broker->addModule(module);
  module->init();
}

}  // namespace AL
