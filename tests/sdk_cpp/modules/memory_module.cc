// A local module that has pointers to ALMemory: one to a sensor, one to a number of its own.

#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodule.h>
#include <almemoryfastaccess/almemoryfastaccess.h>
#include <alproxies/almemoryproxy.h>

#include <atomic>
#include <boost/make_shared.hpp>

namespace {
const char* const kYaw = "Device/SubDeviceList/HeadYaw/Position/Sensor/Value";
const char* const kCount = "MemoryModule/Count";
}  // namespace

class MemoryModule : public AL::ALModule {
 public:
  MemoryModule(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALModule(broker, name), memory_(boost::make_shared<AL::ALMemoryProxy>(broker)) {
    setModuleDescription("Reads and writes through pointers.");
    functionName("cycles", getName(), "How often it was called.");
    BIND_METHOD(MemoryModule::cycles);
    functionName("differences", getName(), "How often the pointer was not what getData says.");
    BIND_METHOD(MemoryModule::differences);
    functionName("refuses", getName(), "Whether there is no pointer to a key.");
    BIND_METHOD(MemoryModule::refuses);
    yaw_ = static_cast<float*>(memory_->getDataPtr(kYaw));
    count_ = AL::ALMemoryFastAccess::getSafeDataPtr(memory_, kCount, 0);
    after_ = getParentBroker()->getProxy("DCM")->getModule()->atPostProcess([this] { look(); });
  }
  ~MemoryModule() override { after_.disconnect(); }

  int cycles() { return cycles_; }
  int differences() { return differences_; }
  bool refuses(const std::string& key) {
    try {
      return memory_->getDataPtr(key) == nullptr;
    } catch (const AL::ALError&) {
      return true;
    }
  }

 private:
  void look() {
    if (*yaw_ != static_cast<float>(memory_->getData(kYaw))) ++differences_;
    *count_ += 1;
    ++cycles_;
  }

  boost::shared_ptr<AL::ALMemoryProxy> memory_;
  ProcessSignalConnection after_;
  float* yaw_ = nullptr;
  int* count_ = nullptr;
  std::atomic<int> cycles_{0};
  std::atomic<int> differences_{0};
};

extern "C" {

int _createModule(boost::shared_ptr<AL::ALBroker> broker) {
  AL::ALBrokerManager::setInstance(broker->fBrokerManager.lock());
  AL::ALBrokerManager::getInstance()->addBroker(broker);
  AL::ALModule::createModule<MemoryModule>(broker, "MemoryModule");
  return 0;
}

int _closeModule() { return 0; }
}
