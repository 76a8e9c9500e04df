// The part of ALVideoDevice about cameras and their parameters rather than windows on them.

#include <algorithm>

#include "naoqi_api/call_error.h"
#include "naoqi_api/services/al_video_device.h"

namespace nao::services {
namespace {

// NaoQi's numbers.
constexpr int kQvga = 1;
constexpr int kDefaultFrameRate = 5;  // [1/s]
constexpr int kCameraSelect = 18;     // parameter: the active camera
constexpr int kSetToDefaults = 19;    // parameter: writing 1 resets all

}  // namespace

bool AlVideoDevice::isCamera(int camera) const {
  return camera >= 0 && camera < static_cast<int>(robot_->cameras.size());
}

const CameraModel& AlVideoDevice::cameraOf(int camera) const {
  if (!isCamera(camera)) {
    throw rpc::CallError("ALVideoDevice: no camera " + std::to_string(camera));
  }
  return robot_->cameras[camera];
}

bool AlVideoDevice::setActiveCamera(int camera) {
  if (!isCamera(camera)) return false;
  active_camera_ = camera;
  for (const std::string& handle : handles()) {
    if (windowOf(handle).follows_active && getCamera(handle) != camera) turn(handle, camera);
  }
  return true;
}

rpc::Value AlVideoDevice::getCameraIndexes() const {
  std::vector<int> indexes;
  for (int i = 0; isCamera(i); ++i) indexes.push_back(i);
  return rpc::toValue(indexes);
}

std::string AlVideoDevice::getCameraName(int camera) const { return cameraOf(camera).name; }

const camera::SensorType& AlVideoDevice::sensorOf(int camera) const {
  return camera::sensorOf(*robot_, cameraOf(camera));
}

const camera::ParameterRange& AlVideoDevice::parameterOf(int camera, int id) const {
  const camera::ParameterRange* const parameter = camera::findParameter(sensorOf(camera), id);
  if (parameter == nullptr) {
    throw rpc::CallError("ALVideoDevice: no camera parameter " + std::to_string(id));
  }
  return *parameter;
}

int AlVideoDevice::getCameraModel(int camera) const { return sensorOf(camera).naoqi_model; }

float AlVideoDevice::getHorizontalFov(int camera) const {
  return static_cast<float>(cameraOf(camera).hfov);
}

float AlVideoDevice::getVerticalFov(int camera) const {
  return static_cast<float>(cameraOf(camera).vfov);
}

int AlVideoDevice::getCameraResolution(int camera) const {
  cameraOf(camera);
  int largest = -1;
  for (const auto& [unused, window] : windows_) {
    if (window.camera == camera && window.resolution <= 4) {
      largest = std::max(largest, window.resolution);  // 0 to 4 ascend, 7 and 8 are smaller
    }
  }
  return largest < 0 ? kQvga : largest;
}

int AlVideoDevice::getCameraColorSpace(int camera) const {
  cameraOf(camera);
  return static_cast<int>(camera::ColorSpace::kYUV422);  // what the sensors deliver
}

int AlVideoDevice::getCameraFrameRate(int camera) const {
  cameraOf(camera);
  int fastest = 0;
  for (const auto& [unused, window] : windows_) {
    if (window.camera == camera) fastest = std::max(fastest, window.frame_rate);
  }
  return fastest == 0 ? kDefaultFrameRate : fastest;
}

bool AlVideoDevice::turnCameraOn(int camera) {
  if (!isCamera(camera)) return false;
  closed_.erase(camera);
  return true;
}

bool AlVideoDevice::turnCameraOff(int camera) {
  cameraOf(camera);
  closed_.insert(camera);
  return true;
}

rpc::Value AlVideoDevice::resolutionToSizes(int resolution) const {
  const auto size = camera::resolutionSize(resolution);
  if (!size) throw rpc::CallError("ALVideoDevice: no resolution " + std::to_string(resolution));
  return rpc::toValue(std::vector<int>{size->width, size->height});
}

int AlVideoDevice::sizesToResolution(int width, int height) const {
  return camera::resolutionOf({width, height}).value_or(-1);
}

int AlVideoDevice::getParameter(int camera, int parameter) const {
  const camera::ParameterRange& known = parameterOf(camera, parameter);
  if (parameter == kCameraSelect) return active_camera_;
  return settings_[camera].get(known);
}

bool AlVideoDevice::setParameter(int camera, int parameter, int value) {
  const camera::ParameterRange& known = parameterOf(camera, parameter);
  if (parameter == kCameraSelect) return setActiveCamera(value);
  if (parameter == kSetToDefaults && value == 1) return setAllParametersToDefault(camera);
  if (!settings_[camera].set(known, value)) return false;
  feed_->setSettings(camera, settings_[camera]);
  return true;
}

bool AlVideoDevice::setParameterToDefault(int camera, int parameter) {
  settings_[camera].reset(parameterOf(camera, parameter));
  feed_->setSettings(camera, settings_[camera]);
  return true;
}

bool AlVideoDevice::setAllParametersToDefault(int camera) {
  cameraOf(camera);
  settings_[camera].resetAll();
  feed_->setSettings(camera, settings_[camera]);
  return true;
}

rpc::Value AlVideoDevice::getParameterRange(int camera, int parameter) const {
  const camera::ParameterRange& known = parameterOf(camera, parameter);
  return rpc::toValue(std::vector<int>{known.min, known.max});
}

int AlVideoDevice::getCameraParameter(const std::string& handle, int parameter) const {
  return getParameter(getCamera(handle), parameter);
}

bool AlVideoDevice::setCameraParameter(const std::string& handle, int parameter, int value) {
  return setParameter(getCamera(handle), parameter, value);
}

bool AlVideoDevice::setCameraParameterToDefault(const std::string& handle, int parameter) {
  return setParameterToDefault(getCamera(handle), parameter);
}

bool AlVideoDevice::setAllCameraParametersToDefault(const std::string& handle) {
  return setAllParametersToDefault(getCamera(handle));
}

rpc::Value AlVideoDevice::getCameraParameterRange(const std::string& handle, int parameter) const {
  return getParameterRange(getCamera(handle), parameter);
}

int AlVideoDevice::getParam(int parameter) const { return getParameter(active_camera_, parameter); }

void AlVideoDevice::setParam(int parameter, int value) {
  setParameter(active_camera_, parameter, value);
}

void AlVideoDevice::setParamDefault(int parameter) {
  setParameterToDefault(active_camera_, parameter);
}

}  // namespace nao::services
