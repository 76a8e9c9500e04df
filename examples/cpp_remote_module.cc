// A module in a program of its own: others call Greeter.greet(name), and it greets whoever touches
// the robot's head:
//   cpp_remote_module --pip HOST --pport PORT

#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodule.h>
#include <alcommon/altoolsmain.h>
#include <alproxies/almemoryproxy.h>
#include <alproxies/altexttospeechproxy.h>
#include <althread/alcriticalsection.h>

#include <iostream>

class Greeter : public AL::ALModule {
 public:
  Greeter(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALModule(broker, name),
        memory_(broker),
        speech_(broker),
        mutex_(AL::ALMutex::createALMutex()) {
    setModuleDescription("Greets.");

    functionName("greet", getName(), "Greets somebody, and returns how many it has greeted.");
    addParam("name", "Whom.");
    setReturn("count", "How many, with this one.");
    BIND_METHOD(Greeter::greet);

    functionName("onTouch", getName(), "Called when the head is touched.");
    BIND_METHOD(Greeter::onTouch);
  }

  ~Greeter() override { memory_.unsubscribeToEvent("FrontTactilTouched", getName()); }

  void init() override {
    memory_.subscribeToEvent("FrontTactilTouched", getName(), "onTouch");
    std::cout << "ready" << std::endl;
  }

  int greet(const std::string& name) {
    speech_.say("Hello, " + name);
    const AL::ALCriticalSection hold(mutex_);
    return ++count_;
  }

  void onTouch(const std::string& /*event*/, const float& pressed, const std::string& /*message*/) {
    if (pressed > 0.5f) std::cout << "touched, " << greet("you") << std::endl;
  }

 private:
  AL::ALMemoryProxy memory_;
  AL::ALTextToSpeechProxy speech_;
  boost::shared_ptr<AL::ALMutex> mutex_;
  int count_ = 0;
};

extern "C" int _createModule(boost::shared_ptr<AL::ALBroker> broker) {
  AL::ALBrokerManager::setInstance(broker->fBrokerManager.lock());
  AL::ALBrokerManager::getInstance()->addBroker(broker);
  AL::ALModule::createModule<Greeter>(broker, "Greeter");
  return 0;
}

int main(int argc, char* argv[]) {
  return ALTools::mainFunction("greeter", argc, argv, _createModule);
}
