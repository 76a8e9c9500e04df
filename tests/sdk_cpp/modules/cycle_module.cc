// A local module: it follows the head's yaw with the pitch, cycle by cycle, and looks at the clock.

#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodule.h>
#include <almemoryfastaccess/almemoryfastaccess.h>
#include <alproxies/almotionproxy.h>
#include <alproxies/dcmproxy.h>

#include <atomic>
#include <boost/bind/bind.hpp>

class CycleModule : public AL::ALModule {
 public:
  CycleModule(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALModule(broker, name) {
    setModuleDescription("Follows the head's yaw with its pitch.");
    functionName("worstStep", getName(), "Longest time between two cycles [ms], 0 before two.");
    BIND_METHOD(CycleModule::worstStep);
    functionName("cycles", getName(), "How often it was called.");
    BIND_METHOD(CycleModule::cycles);
    functionName("phases", getName(), "How often more the end of cycles came than the beginning.");
    BIND_METHOD(CycleModule::phases);
    functionName("hang", getName(), "Waits for a motion in the next cycle.");
    BIND_METHOD(CycleModule::hang);
    follow();
  }
  ~CycleModule() override { after_.disconnect(); }

  int worstStep() { return worst_step_; }
  int cycles() { return cycles_; }
  int phases() { return phases_; }
  void hang() { hangs_ = true; }

 private:
  void follow() {
    dcm_ = getParentBroker()->getDcmProxy();
    motion_ = getParentBroker()->getMotionProxy();
    memory_.ConnectToVariables(getParentBroker(),
                               {"Device/SubDeviceList/HeadYaw/Position/Sensor/Value"});
    command_ = AL::ALValue::array("HeadPitch/Position/Actuator/Value", "ClearAll",
                                  AL::ALValue::array(AL::ALValue::array(0.0f, 0)));
    after_ = getParentBroker()->getProxy("DCM")->getModule()->atPostProcess(
        boost::bind(&CycleModule::afterCycle, this));
    before_ = getParentBroker()->getProxy("DCM")->getModule()->atPreProcess([this] { --phases_; });
  }

  void afterCycle() {
    const int now = dcm_->getTime(0);
    if (cycles_ > 0 && now - last_ > worst_step_) worst_step_ = now - last_;
    last_ = now;
    ++cycles_;
    ++phases_;
    memory_.GetValues(values_);
    command_[2][0][0] = -values_[0] / 2;
    command_[2][0][1] = now;
    dcm_->set(command_);
    if (hangs_.exchange(false)) motion_->angleInterpolation("LShoulderPitch", 1.0f, 0.5f, true);
  }

  boost::shared_ptr<AL::DCMProxy> dcm_;
  boost::shared_ptr<AL::ALMotionProxy> motion_;
  AL::ALMemoryFastAccess memory_;
  ProcessSignalConnection after_;
  ProcessSignalConnection before_;
  std::vector<float> values_;
  AL::ALValue command_;
  int last_ = 0;
  std::atomic<int> worst_step_{0};
  std::atomic<int> cycles_{0};
  std::atomic<int> phases_{0};
  std::atomic<bool> hangs_{false};
};

extern "C" {

int _createModule(boost::shared_ptr<AL::ALBroker> broker) {
  AL::ALBrokerManager::setInstance(broker->fBrokerManager.lock());
  AL::ALBrokerManager::getInstance()->addBroker(broker);
  AL::ALModule::createModule<CycleModule>(broker, "CycleModule");
  return 0;
}

int _closeModule() { return 0; }
}
