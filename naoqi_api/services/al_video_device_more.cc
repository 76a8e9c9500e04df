// The rest of ALVideoDevice: several cameras at once, the geometry of pictures, and old names.

#include <algorithm>

#include "naoqi_api/call_error.h"
#include "naoqi_api/services/al_video_device.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;
using Floats = std::vector<float>;

Argument handle() { return {"name", "What subscribing returned."}; }

float at(const Floats& values, std::size_t i) {
  if (i >= values.size()) throw CallError("expected more numbers");
  return values[i];
}

// A picture's own coordinates go from 0 to 1, x to the right and y down; angles are to the left
// and down from its middle [rad].
Floats anglesOf(const CameraModel& camera, const Floats& place) {
  return {static_cast<float>((0.5 - at(place, 0)) * camera.hfov),
          static_cast<float>((at(place, 1) - 0.5) * camera.vfov)};
}
Floats placeOf(const CameraModel& camera, const Floats& angles) {
  return {static_cast<float>(0.5 - at(angles, 0) / camera.hfov),
          static_cast<float>(0.5 + at(angles, 1) / camera.vfov)};
}
Floats angularSize(const CameraModel& camera, const Floats& size) {
  return {static_cast<float>(at(size, 0) * camera.hfov),
          static_cast<float>(at(size, 1) * camera.vfov)};
}
Floats imageSize(const CameraModel& camera, const Floats& size) {
  return {static_cast<float>(at(size, 0) / camera.hfov),
          static_cast<float>(at(size, 1) / camera.vfov)};
}
// [x, y, width, height] of [yaw, pitch, width, height].
Floats infoOf(const CameraModel& camera, const Floats& angular) {
  const Floats place = placeOf(camera, angular);
  const Floats size = imageSize(camera, {at(angular, 2), at(angular, 3)});
  return {place[0], place[1], size[0], size[1]};
}

using Geometry = Floats (*)(const CameraModel&, const Floats&);
struct GeometryNames {
  const char* name;
  const char* old_name;  // of NAOqi 1.x, for the active camera
  Geometry calc;
  const char* meaning;
};
constexpr GeometryNames kGeometry[] = {
    {"getAngularPositionFromImagePosition", "getAngPosFromImgPos", anglesOf,
     "[yaw, pitch] of a place in the picture."},
    {"getImagePositionFromAngularPosition", "getImgPosFromAngPos", placeOf,
     "The place in the picture of [yaw, pitch]."},
    {"getAngularSizeFromImageSize", "getAngSizeFromImgSize", angularSize,
     "The angles that a part of the picture spans."},
    {"getImageSizeFromAngularSize", "getImgSizeFromAngSize", imageSize,
     "The part of the picture that angles span."},
    {"getImageInfoFromAngularInfo", "getImgInfoFromAngInfo", infoOf,
     "[x, y, width, height] of [yaw, pitch, width, height]."},
};

Floats inPixels(Floats info, int resolution) {
  const auto size = camera::resolutionSize(resolution);
  if (!size) throw CallError("no resolution " + std::to_string(resolution));
  for (std::size_t i = 0; i < info.size(); ++i) {
    info[i] *= static_cast<float>(i % 2 == 0 ? size->width : size->height);
  }
  return info;
}

}  // namespace

void AlVideoDevice::describeMore(rpc::Service& service) {
  describeGeometry(service);
  describeSeveral(service);
  describeSeveralSettings(service);
  describeOldNames(service);
  describeSimulator(service);
  describeFiles(service);
}

void AlVideoDevice::describeGeometry(rpc::Service& service) {
  const Argument values{"values", "Places and sizes 0 to 1 of the picture; angles [rad]."};
  const Argument camera{"camera", "0: top, 1: bottom."};
  for (const GeometryNames& names : kGeometry) {
    addFunction(
        service, names.name,
        [this, calc = names.calc](int which, const Floats& given) {
          return calc(cameraOf(which), given);
        },
        names.meaning, camera, values);
    addFunction(
        service, names.old_name,
        [this, calc = names.calc](const Floats& given) {
          return calc(cameraOf(active_camera_), given);
        },
        names.meaning, values);
  }
  const Argument resolution{"resolution", "NaoQi's number."};
  const char* meaning = "[x, y, width, height] in pixels of [yaw, pitch, width, height].";
  addFunction(
      service, "getImageInfoFromAngularInfoWithResolution",
      [this](int which, const Floats& given, int of) {
        return inPixels(infoOf(cameraOf(which), given), of);
      },
      meaning, camera, values, resolution);
  addFunction(
      service, "getImgInfoFromAngInfoWithRes",
      [this](const Floats& given, int of) {
        return inPixels(infoOf(cameraOf(active_camera_), given), of);
      },
      meaning, values, resolution);
}

const std::vector<std::string>& AlVideoDevice::windowsOf(const std::string& name) const {
  const auto found = several_.find(name);
  if (found == several_.end()) throw CallError("ALVideoDevice: no subscriber \"" + name + "\"");
  return found->second;
}

std::string AlVideoDevice::subscribeCameras(const rpc::Caller& caller, const std::string& name,
                                            const Value& cameras, const Value& resolutions,
                                            const Value& color_spaces, int frame_rate) {
  const auto which = cameras.to<std::vector<int>>();
  const auto sizes = resolutions.to<std::vector<int>>();
  const auto spaces = color_spaces.to<std::vector<int>>();
  if (which.empty() || sizes.size() != which.size() || spaces.size() != which.size()) {
    throw CallError("expected as many resolutions and colour spaces as cameras");
  }
  std::vector<std::string> opened;
  for (std::size_t i = 0; i < which.size(); ++i) {
    opened.push_back(open(caller, name, makeWindow(which[i], sizes[i], spaces[i], frame_rate)));
    if (!opened.back().empty()) continue;
    for (const std::string& window : opened) unsubscribe(window);
    return {};
  }
  const std::string all = opened.front() + "_multi";
  several_[all] = opened;
  return all;
}

bool AlVideoDevice::unsubscribeAny(const std::string& name) {
  const auto found = several_.find(name);
  if (found == several_.end()) return unsubscribe(name);
  bool all = true;
  for (const std::string& window : found->second) all = unsubscribe(window) && all;
  several_.erase(found);
  return all;
}

// The pictures of all cameras, when the last has come.
rpc::Pending<Value> AlVideoDevice::getSeveral(const std::string& name, ImageGetter get) {
  const auto& windows = windowsOf(name);
  const auto images = std::make_shared<std::vector<Value>>(windows.size());
  const auto missing = std::make_shared<std::size_t>(windows.size());
  rpc::Pending<Value> all;
  all.onlyWaits();
  for (std::size_t i = 0; i < windows.size(); ++i) {
    (this->*get)(windows[i]).whenDone([images, missing, all, i](const auto& outcome) {
      if (outcome.value) (*images)[i] = *outcome.value;
      if (--*missing == 0) all.resolve(Value::list(*images));
    });
  }
  return all;
}

void AlVideoDevice::describeSeveral(rpc::Service& service) {
  addFunction(
      service, "subscribeCameras",
      [this](const rpc::Caller& caller, const std::string& name, const Value& cameras,
             const Value& sizes, const Value& spaces,
             int rate) { return subscribeCameras(caller, name, cameras, sizes, spaces, rate); },
      "Opens a window on several cameras; its name, or nothing if that can not be.",
      Argument{"name", "To which a number is added."}, Argument{"cameras", "[camera, ...]"},
      Argument{"resolutions", "One each."}, Argument{"colorSpaces", "One each."},
      Argument{"fps", "[1/s]"});
  for (const char* name : {"getImagesRemote", "getImagesLocal"}) {
    addFunction(
        service, name,
        [this](const std::string& all) { return getSeveral(all, &AlVideoDevice::getImageRemote); },
        "The newest picture of each camera.", handle());
  }
  for (const char* name : {"getDirectRawImagesRemote", "getDirectRawImagesLocal"}) {
    addFunction(
        service, name,
        [this](const std::string& all) {
          return getSeveral(all, &AlVideoDevice::getDirectRawImage);
        },
        "The newest picture of each camera as its sensor gives it: YUV422.", handle());
  }
  for (const char* name : {"releaseImages", "releaseDirectRawImages"}) {
    addFunction(
        service, name,
        [this](const std::string& all) {
          return rpc::toValue(std::vector<bool>(windowsOf(all).size(), true));
        },
        "True for each camera: pictures are shared, so there is nothing to release.", handle());
  }
}

void AlVideoDevice::describeSeveralSettings(rpc::Service& service) {
  using Getter = int (AlVideoDevice::*)(const std::string&) const;
  using Setter = bool (AlVideoDevice::*)(const std::string&, int);
  struct Setting {
    const char* what;
    Getter get;
    Setter set;
  };
  for (const Setting& setting :
       {Setting{"Resolutions", &AlVideoDevice::getResolution, &AlVideoDevice::setResolution},
        Setting{"ColorSpaces", &AlVideoDevice::getColorSpace, &AlVideoDevice::setColorSpace},
        Setting{"ActiveCameras", &AlVideoDevice::getCamera, &AlVideoDevice::setCamera}}) {
    addFunction(
        service, std::string("get") + setting.what,
        [this, get = setting.get](const std::string& all) {
          std::vector<int> values;
          for (const std::string& window : windowsOf(all)) values.push_back((this->*get)(window));
          return rpc::toValue(values);
        },
        "What is set, one for each camera.", handle());
    addFunction(
        service, std::string("set") + setting.what,
        [this, set = setting.set](const std::string& all, const Value& wanted) {
          const auto values = wanted.to<std::vector<int>>();
          const auto& windows = windowsOf(all);
          if (values.size() != windows.size()) throw CallError("expected one for each camera");
          std::vector<bool> done;
          for (std::size_t i = 0; i < windows.size(); ++i) {
            done.push_back((this->*set)(windows[i], values[i]));
          }
          return rpc::toValue(done);
        },
        "Whether it could be set, for each camera.", handle(),
        Argument{"values", "One for each camera."});
  }
  const Argument parameter{"parameter", "NaoQi's number."};
  addFunction(
      service, "getCamerasParameter",
      [this](const std::string& all, int which) {
        std::vector<int> values;
        for (const auto& window : windowsOf(all))
          values.push_back(getCameraParameter(window, which));
        return rpc::toValue(values);
      },
      "A parameter's value, for each camera.", handle(), parameter);
  addFunction(
      service, "setCamerasParameter",
      [this](const std::string& all, int which, const Value& wanted) {
        const auto values = wanted.to<std::vector<int>>();
        const auto& windows = windowsOf(all);
        if (values.size() != windows.size()) throw CallError("expected one for each camera");
        std::vector<bool> done;
        for (std::size_t i = 0; i < windows.size(); ++i) {
          done.push_back(setCameraParameter(windows[i], which, values[i]));
        }
        return rpc::toValue(done);
      },
      "Whether it could be set, for each camera.", handle(), parameter,
      Argument{"values", "One for each camera."});
  addFunction(
      service, "setCamerasParameterToDefault",
      [this](const std::string& all, int which) {
        std::vector<bool> done;
        for (const auto& window : windowsOf(all)) {
          done.push_back(setCameraParameterToDefault(window, which));
        }
        return rpc::toValue(done);
      },
      "Whether it could be set, for each camera.", handle(), parameter);
}

void AlVideoDevice::describeOldNames(rpc::Service& service) {
  addFunction(
      service, "getImageLocal", [this](const std::string& name) { return getImageRemote(name); },
      "As getImageRemote: a client of another process gets a copy.", handle());
  for (const char* name : {"getDirectRawImageRemote", "getDirectRawImageLocal"}) {
    addFunction(
        service, name, [this](const std::string& window) { return getDirectRawImage(window); },
        "The newest picture as the sensor gives it: YUV422, whatever the window's colour space.",
        handle());
  }
  addFunction(
      service, "releaseDirectRawImage",
      [this](const std::string& window) { return releaseImage(window); },
      "Whether there is such a window.", handle());
  addFunction(
      service, "getCameraModelID", [this] { return getCameraModel(active_camera_); },
      "The active camera's sensor.");
  addFunction(
      service, "getVIMResolution", [this] { return getCameraResolution(active_camera_); },
      "The active camera's resolution.");
  addFunction(
      service, "getVIMColorSpace", [this] { return getCameraColorSpace(active_camera_); },
      "The active camera's colour space.");
  addFunction(
      service, "getVIMFrameRate", [this] { return getCameraFrameRate(active_camera_); },
      "The active camera's frame rate [1/s].");
  addFunction(
      service, "isFrameGrabberOff", [this] { return isCameraOff(active_camera_) ? 1 : 0; },
      "1 if the active camera is off.");
  addFunction(
      service, "startFrameGrabber", [this] { return turnCameraOn(active_camera_); },
      "Switches the active camera on.");
  addFunction(
      service, "stopFrameGrabber", [this] { return turnCameraOff(active_camera_); },
      "Switches the active camera off: no pictures.");
  addFunction(
      service, "stopFrameGrabber", [this](int camera) { return turnCameraOff(camera); },
      "Switches a camera off: no pictures.", Argument{"camera", "0: top, 1: bottom."});
  addFunction(
      service, "resetCamera", [this](int camera) { return setAllParametersToDefault(camera); },
      "Sets a camera's parameters to their defaults.", Argument{"camera", "0: top, 1: bottom."});
}

}  // namespace nao::services
