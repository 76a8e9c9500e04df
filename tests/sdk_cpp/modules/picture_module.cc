// A local module that looks through the robot's cameras without a copy of the pixels.

#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodule.h>
#include <alproxies/alvideodeviceproxy.h>
#include <alvision/alimage.h>

#include <cstring>

class PictureModule : public AL::ALModule {
 public:
  PictureModule(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALModule(broker, name), video_(broker) {
    setModuleDescription("Looks at pictures.");
    functionName("size", getName(), "Width, height and bytes of a picture.");
    BIND_METHOD(PictureModule::size);
    functionName("sharesPixels", getName(), "Whether two equal windows show the same bytes.");
    BIND_METHOD(PictureModule::sharesPixels);
    functionName("isAsRemote", getName(), "Whether local and remote pictures are equal.");
    BIND_METHOD(PictureModule::isAsRemote);
    functionName("staysUntilReleased", getName(), "Whether a picture outlives those after it.");
    BIND_METHOD(PictureModule::staysUntilReleased);
    functionName("nobodysIsNull", getName(), "Whether there is no picture of no window.");
    BIND_METHOD(PictureModule::nobodysIsNull);
    one_ = video_.subscribeCamera("one", 0, AL::kVGA, AL::kRGBColorSpace, 30);
    two_ = video_.subscribeCamera("two", 0, AL::kVGA, AL::kRGBColorSpace, 30);
  }

  AL::ALValue size() {
    const AL::ALImage* image = look(one_);
    return AL::ALValue::array(image->getWidth(), image->getHeight(),
                              static_cast<int>(image->getSize()));
  }

  bool sharesPixels() {
    for (;;) {  // one of the two may just have a newer one
      const AL::ALImage* one = look(one_);
      const AL::ALImage* two = look(two_);
      if (one->getTimeStamp() == two->getTimeStamp()) return one->getData() == two->getData();
    }
  }

  bool isAsRemote() {
    for (;;) {
      const AL::ALImage* image = look(one_);
      const AL::ALImage remote(video_.getImageRemote(one_));
      if (remote.getTimeStamp() != image->getTimeStamp()) continue;
      return image->getSize() == remote.getSize() && image->getCameraId() == 0 &&
             image->getLeftAngle() == remote.getLeftAngle() &&
             std::memcmp(image->getData(), remote.getData(), remote.getSize()) == 0;
    }
  }

  bool staysUntilReleased() {
    const AL::ALImage* image = look(one_);
    const std::string before(reinterpret_cast<const char*>(image->getData()), image->getSize());
    const long long time = image->getTimeStamp();
    while (AL::ALImage(video_.getImageRemote(two_)).getTimeStamp() < time + 300000) continue;
    const bool is_there = std::memcmp(image->getData(), before.data(), before.size()) == 0;
    return is_there && video_.releaseImage(one_);
  }

  bool nobodysIsNull() { return video_.getImageLocal("nobody") == NULL; }

 private:
  AL::ALImage* look(const std::string& window) {
    return static_cast<AL::ALImage*>(video_.getImageLocal(window));
  }

  AL::ALVideoDeviceProxy video_;
  std::string one_;
  std::string two_;
};

extern "C" {

int _createModule(boost::shared_ptr<AL::ALBroker> broker) {
  AL::ALBrokerManager::setInstance(broker->fBrokerManager.lock());
  AL::ALBrokerManager::getInstance()->addBroker(broker);
  AL::ALModule::createModule<PictureModule>(broker, "PictureModule");
  return 0;
}

int _closeModule() { return 0; }
}
