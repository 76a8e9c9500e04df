// With the include paths of NAOqi 1.x.
#include <albroker.h>
#include <albrokermanager.h>
#include <alcore/alptr.h>
#include <almodule.h>
#include <almotionproxy.h>
#include <altoolsmain.h>
#include <qi/log.hpp>

qiLogCategory("old.module");

class OldModule : public AL::ALModule {
 public:
  OldModule(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALModule(broker, name) {
    functionName("joints", getName(), "How many joints the robot has.");
    BIND_METHOD(OldModule::joints);
    qiLogInfo() << "made " << name << std::endl;
    qiLogVerbose("old.module", "%d arguments", 2);
  }
  int joints() {
    AL::ALPtr<AL::ALMotionProxy> motion(new AL::ALMotionProxy(getParentBroker()));
    return static_cast<int>(motion->getBodyNames("Body").size());
  }
};

extern "C" int _createModule(boost::shared_ptr<AL::ALBroker> pBroker) {
  AL::ALBrokerManager::setInstance(pBroker->fBrokerManager.lock());
  AL::ALBrokerManager::getInstance()->addBroker(pBroker);
  AL::ALModule::createModule<OldModule>(pBroker, "OldModule");
  return 0;
}

#ifdef MODULE_IS_REMOTE
int main(int argc, char* argv[]) {
  TMainType sig;
  sig = &_createModule;
  return ALTools::mainFunction("oldmodule", argc, argv, sig);
}
#endif
