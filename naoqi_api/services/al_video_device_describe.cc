// The declaration of ALVideoDevice: names and meanings as clients see them.

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/al_video_device.h"

namespace nao::services {
namespace {

using rpc::Argument;

Argument handle() { return {"handle", "What subscribeCamera returned."}; }
Argument camera() { return {"cameraIndex", "0: top, 1: bottom."}; }
Argument resolution() { return {"resolution", "0: 160x120, 1: 320x240, 2: 640x480, 3: 1280x960."}; }
Argument colorSpace() { return {"colorSpace", "0: Y, 9: YUV422, 10: YUV, 11: RGB, 13: BGR."}; }
Argument frameRate() { return {"fps", "Pictures a second; rounded up to what the camera offers."}; }
Argument parameter() { return {"parameterId", "Number of the parameter, e.g. 0: brightness."}; }
Argument value() { return {"value", "New value of the parameter."}; }
Argument name() { return {"name", "Name of the subscriber."}; }

}  // namespace

rpc::Service AlVideoDevice::describe() {
  rpc::Service service =
      rpc::alModule("ALVideoDevice", "Pictures from the robot's cameras, and their settings.");
  describeWindows(service);
  describeWindowSettings(service);
  describeCameras(service);
  describeParameters(service);
  describeWindowParameters(service);
  describeMore(service);
  return service;
}

void AlVideoDevice::describeWindows(rpc::Service& service) {
  using Self = AlVideoDevice;
  service
      .method("subscribeCamera", this, &Self::subscribeCamera,
              "Opens a window on a camera. Returns its handle; empty if that is not possible.",
              name(), camera(), resolution(), colorSpace(), frameRate())
      .method("subscribe", this, &Self::subscribe,
              "Opens a window on the active camera, whichever that is. Returns its handle.", name(),
              resolution(), colorSpace(), frameRate())
      .method("unsubscribe", this, &Self::unsubscribeAny, "Closes a window.", handle())
      .method("unsubscribeAllInstances", this, &Self::unsubscribeAllInstances,
              "Closes all windows of a subscriber.", name())
      .method("getSubscribers", this, &Self::getSubscribers, "The handles of all open windows.")
      .method(
          "getImageRemote", this, &Self::getImageRemote,
          "The newest picture: width, height, bytes per pixel, colour space, seconds, "
          "microseconds, bytes, camera, left, top, right and bottom angle [rad]. Nothing if the "
          "handle is unknown.",
          handle())
      .method("releaseImage", this, &Self::releaseImage,
              "Tells that the picture is no longer needed. False if the handle is unknown.",
              handle());
}

void AlVideoDevice::describeWindowSettings(rpc::Service& service) {
  using Self = AlVideoDevice;
  service.method("getActiveCamera", this, &Self::getCamera, "The camera a window shows.", handle())
      .method("setActiveCamera", this, &Self::setCamera, "Turns a window to another camera.",
              handle(), camera())
      .method("getResolution", this, &Self::getResolution, "The resolution of a window.", handle())
      .method("setResolution", this, &Self::setResolution, "Changes the resolution of a window.",
              handle(), resolution())
      .method("getColorSpace", this, &Self::getColorSpace, "The colour space of a window.",
              handle())
      .method("setColorSpace", this, &Self::setColorSpace, "Changes the colour space of a window.",
              handle(), colorSpace())
      .method("getFrameRate", this, &Self::getFrameRate, "The frame rate of a window [1/s].",
              handle())
      .method("setFrameRate", this, &Self::setFrameRate, "Changes the frame rate of a window.",
              handle(), frameRate())
      .method("getGVMResolution", this, &Self::getResolution, "Older name of getResolution.",
              handle())
      .method("getGVMColorSpace", this, &Self::getColorSpace, "Older name of getColorSpace.",
              handle())
      .method("getGVMFrameRate", this, &Self::getFrameRate, "Older name of getFrameRate.",
              handle());
}

void AlVideoDevice::describeCameras(rpc::Service& service) {
  using Self = AlVideoDevice;
  service.method("getActiveCamera", this, &Self::getActiveCamera, "The camera subscribe() shows.")
      .method("setActiveCamera", this, &Self::setActiveCamera, "Sets the camera subscribe() shows.",
              camera())
      .method("getCameraIndexes", this, &Self::getCameraIndexes, "All cameras.")
      .method("getCameraName", this, &Self::getCameraName, "CameraTop or CameraBottom.", camera())
      .method("getCameraModel", this, &Self::getCameraModel,
              "The sensor. 1: OV7670, 2: MT9M114, 3: OV5640.", camera())
      .method("getHorizontalFOV", this, &Self::getHorizontalFov,
              "How much is seen from left to right [rad].", camera())
      .method("getVerticalFOV", this, &Self::getVerticalFov,
              "How much is seen from top to bottom [rad].", camera())
      .method("getHorizontalAperture", this, &Self::getHorizontalFov,
              "Older name of getHorizontalFOV.", camera())
      .method("getVerticalAperture", this, &Self::getVerticalFov, "Older name of getVerticalFOV.",
              camera())
      .method("getResolution", this, &Self::getCameraResolution,
              "The largest resolution asked of a camera.", camera())
      .method("getColorSpace", this, &Self::getCameraColorSpace,
              "The colour space a camera delivers by itself.", camera())
      .method("getFrameRate", this, &Self::getCameraFrameRate,
              "The highest frame rate asked of a camera [1/s].", camera())
      .method("isCameraOpen", this, &Self::isCameraOn, "Whether a camera is on.", camera())
      .method("isCameraStarted", this, &Self::isCameraOn, "Whether a camera is on.", camera())
      .method("openCamera", this, &Self::turnCameraOn, "Switches a camera on.", camera())
      .method("startCamera", this, &Self::turnCameraOn, "Switches a camera on.", camera())
      .method("startFrameGrabber", this, &Self::turnCameraOn, "Switches a camera on.", camera())
      .method("isFrameGrabberOff", this, &Self::isCameraOff, "Whether a camera is off.", camera())
      .method("closeCamera", this, &Self::turnCameraOff, "Switches a camera off: no pictures.",
              camera())
      .method("stopCamera", this, &Self::turnCameraOff, "Switches a camera off: no pictures.",
              camera())
      .method("hasDepthCamera", this, &Self::hasDepthCamera, "False.")
      .method("resolutionToSizes", this, &Self::resolutionToSizes,
              "Width and height of a resolution [px].", resolution())
      .method("sizesToResolution", this, &Self::sizesToResolution,
              "The resolution of this size; -1 if there is none.", Argument{"width", "Width [px]."},
              Argument{"height", "Height [px]."});
}

void AlVideoDevice::describeParameters(rpc::Service& service) {
  using Self = AlVideoDevice;
  service
      .method("getParameter", this, &Self::getParameter, "The value of a parameter.", camera(),
              parameter())
      .method("setParameter", this, &Self::setParameter,
              "Sets a parameter. False if the value is out of range.", camera(), parameter(),
              value())
      .method("setParameterToDefault", this, &Self::setParameterToDefault, "Resets a parameter.",
              camera(), parameter())
      .method("setAllParametersToDefault", this, &Self::setAllParametersToDefault,
              "Resets all parameters.", camera())
      .method("getParameterRange", this, &Self::getParameterRange,
              "The smallest and the largest value.", camera(), parameter())
      .method("getParam", this, &Self::getParam, "A parameter of the active camera.", parameter())
      .method("getParam", this, &Self::getParamOf, "A parameter of a camera.", parameter(),
              camera())
      .method("setParam", this, &Self::setParam, "Sets a parameter of the active camera.",
              parameter(), value())
      .method("setParam", this, &Self::setParamOf, "Sets a parameter of a camera.", parameter(),
              value(), camera())
      .method("setParamDefault", this, &Self::setParamDefault,
              "Resets a parameter of the active camera.", parameter());
}

void AlVideoDevice::describeWindowParameters(rpc::Service& service) {
  using Self = AlVideoDevice;
  service
      .method("getCameraParameter", this, &Self::getCameraParameter,
              "A parameter of the camera of a window.", handle(), parameter())
      .method("setCameraParameter", this, &Self::setCameraParameter,
              "Sets a parameter of the camera of a window.", handle(), parameter(), value())
      .method("setCameraParameterToDefault", this, &Self::setCameraParameterToDefault,
              "Resets a parameter of the camera of a window.", handle(), parameter())
      .method("setAllCameraParametersToDefault", this, &Self::setAllCameraParametersToDefault,
              "Resets all parameters of the camera of a window.", handle())
      .method("getCameraParameterRange", this, &Self::getCameraParameterRange,
              "The smallest and the largest value.", handle(), parameter());
}

}  // namespace nao::services
