// What ALVideoDevice has for simulators and for files: pictures that a client puts in place of the
// camera's, pictures written below the data directory, and what parameters take.

#include <algorithm>
#include <cstdio>

#include "camera/color_conversion.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/services/al_video_device.h"
#include "naoqi_api/services/data_files.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr int kMostPixels = 1280 * 960;
constexpr int kMostRecorded = 1000;

// A picture of another size: every pixel takes the nearest.
camera::Raster resize(const camera::Bytes& rgb, camera::ImageSize from, camera::ImageSize to) {
  camera::Raster raster;
  raster.reset(to);
  for (int row = 0; row < to.height; ++row) {
    camera::Pixel* const pixels = raster.colors(row);
    const std::size_t line = static_cast<std::size_t>(row * from.height / to.height) * from.width;
    for (int column = 0; column < to.width; ++column) {
      const auto* at = &rgb[3 * (line + static_cast<std::size_t>(column * from.width / to.width))];
      pixels[column] = camera::toPixel({at[0], at[1], at[2]});
    }
  }
  return raster;
}

// Netpbm where the colour space allows, else the bytes alone.
std::pair<std::string, std::string> fileOf(const camera::Image& image) {
  const bool is_rgb = image.color_space == camera::ColorSpace::kRGB;
  const bool is_gray = camera::layers(image.color_space) == 1;
  std::string content;
  if (is_rgb || is_gray) {
    content = std::string(is_rgb ? "P6\n" : "P5\n") + std::to_string(image.size.width) + " " +
              std::to_string(image.size.height) + "\n255\n";
  }
  content.append(image.bytes->begin(), image.bytes->end());
  return {is_rgb ? ".ppm" : is_gray ? ".pgm" : ".raw", content};
}

}  // namespace

void AlVideoDevice::connect(std::function<SimTime()> now, std::filesystem::path data_dir) {
  now_ = std::move(now);
  data_dir_ = std::move(data_dir);
}

AlVideoDevice::Picture AlVideoDevice::pictureOf(const Window& window) const {
  const Picture put = putPicture(window, window.color_space);
  return put ? put : feed_->latest(window.subscription);
}

AlVideoDevice::Picture AlVideoDevice::rawPictureOf(const Window& window) const {
  const Picture put = putPicture(window, camera::ColorSpace::kYUV422);
  return put ? put : feed_->latest(window.raw);
}

AlVideoDevice::Picture AlVideoDevice::putPicture(const Window& window,
                                                 camera::ColorSpace space) const {
  const auto put = put_.find(window.camera);
  if (put == put_.end()) return nullptr;
  camera::Image image;
  image.size = *camera::resolutionSize(window.resolution);
  image.color_space = space;
  image.time = put->second.time;
  image.camera = window.camera;
  image.bytes = std::make_shared<const camera::Bytes>(
      camera::toBytes(resize(put->second.rgb, put->second.size, image.size), space));
  return std::make_shared<const camera::Image>(std::move(image));
}

bool AlVideoDevice::putImage(const rpc::Caller& caller, int camera, int width, int height,
                             const Value& bytes) {
  cameraOf(camera);
  const auto given = bytes.findBytes();
  const std::string* text = bytes.findText();
  if (!given && !text) throw CallError("expected the bytes of a picture");
  camera::Bytes rgb = given ? *given : camera::Bytes(text->begin(), text->end());
  if (rgb.empty()) return put_.erase(camera) > 0;
  const bool is_sized = width > 0 && height > 0 && width <= kMostPixels / height;
  if (!is_sized || rgb.size() != static_cast<std::size_t>(width) * height * 3) return false;
  if (caller.session) watch(caller.session);
  put_[camera] = {{width, height}, std::move(rgb), now_(), caller.id()};
  return true;
}

bool AlVideoDevice::setInputSize(int width, int height) {
  if (width <= 0 || height <= 0 || width > kMostPixels / height) return false;
  input_size_ = {width, height};
  return true;
}

Value AlVideoDevice::getExpectedImageParameters(int camera) const {
  cameraOf(camera);
  camera::ImageSize size = input_size_;
  if (size.width == 0) size = *camera::resolutionSize(getCameraResolution(camera));
  const auto space = camera::ColorSpace::kRGB;
  return Value::list({size.width, size.height, camera::layers(space), static_cast<int>(space)});
}

void AlVideoDevice::describeSimulator(rpc::Service& service) {
  const Argument camera{"camera", "0: top, 1: bottom."};
  const Argument bytes{"imageBuffer", "Red, green, blue of each pixel; none: the camera again."};
  addFunction(
      service, "putImage",
      [this](const rpc::Caller& caller, int which, int width, int height, const Value& image) {
        return putImage(caller, which, width, height, image);
      },
      "Shows a picture in place of a camera's, until its client goes. False if bytes and size do "
      "not fit.",
      camera, Argument{"width", "[px]"}, Argument{"height", "[px]"}, bytes);
  addFunction(
      service, "putImage",
      [this](const rpc::Caller& caller, const Value& image) {
        const auto expected = getExpectedImageParameters(active_camera_).to<std::vector<int>>();
        return putImage(caller, active_camera_, expected[0], expected[1], image);
      },
      "Shows a picture of the expected size in place of the active camera's.", bytes);
  const char* const expected = "[width, height, bytes a pixel, colour space] of pictures to put.";
  addFunction(
      service, "getExpectedImageParameters",
      [this](int which) { return getExpectedImageParameters(which); }, expected, camera);
  addFunction(
      service, "getExpectedImageParameters",
      [this] { return getExpectedImageParameters(active_camera_); }, expected);
  addFunction(
      service, "setSimCamInputSize",
      [this](int width, int height) { return setInputSize(width, height); },
      "The size of pictures to put.", Argument{"width", "[px]"}, Argument{"height", "[px]"});
  addFunction(
      service, "onClientDisconnected",
      [this](const std::string&, const Value& client, const std::string&) {
        if (const std::string* name = client.findText()) unsubscribeAllInstances(*name);
      },
      "Closes the windows of a client that has gone.", Argument{"eventName", "Changes nothing."},
      Argument{"eventContents", "The name it subscribed with."},
      Argument{"message", "Changes nothing."});
}

bool AlVideoDevice::recordVideo(const std::string& handle, const std::string& path, int count,
                                int period) {
  if (findWindow(handle) == nullptr || count <= 0 || period <= 0) return false;
  dataPath(data_dir_, path);
  recordings_[handle] = {path, std::min(count, kMostRecorded), period, 0, 0, {}};
  return true;
}

// What can not be written ends its recording.
void AlVideoDevice::recordDue() {
  for (auto next = recordings_.begin(); next != recordings_.end();) {
    const auto recording = next++;
    Recording& record = recording->second;
    const auto image = pictureOf(windows_.at(recording->first));
    if (!image || (record.seen > 0 && image->time == record.last)) continue;
    record.last = image->time;
    if (record.seen++ % record.period != 0) continue;
    const auto [ending, content] = fileOf(*image);
    char number[16];
    std::snprintf(number, sizeof number, "_%04d", record.written++);
    try {
      writeDataFile(data_dir_, record.path + number + ending, content);
      if (--record.left > 0) continue;
    } catch (const CallError&) {
    }
    recordings_.erase(recording);
  }
}

Value AlVideoDevice::getParameterInfo(int camera, int parameter) const {
  const camera::ParameterRange& known = parameterOf(camera, parameter);
  return Value::list({known.min, known.max, known.initial, getParameter(camera, parameter)});
}

void AlVideoDevice::describeFiles(rpc::Service& service) {
  const Argument handle{"id", "What subscribing returned."};
  addFunction(
      service, "recordVideo",
      [this](const std::string& window, const std::string& path, int count, int period) {
        return recordVideo(window, path, count, period);
      },
      "Writes pictures of a window below --data-dir: path_0000.ppm of RGB ones, .pgm of one "
      "channel, .raw of others.",
      handle, Argument{"path", "Without number and ending."},
      Argument{"totalNumber", "How many; 1,000 at most."},
      Argument{"period", "Every how many of the window's pictures."});
  addFunction(
      service, "stopVideo", [this](const std::string& window) { return stopVideo(window); },
      "Ends recordVideo; whether there was one.", handle);
  const Argument parameter{"parameter", "NaoQi's number."};
  const char* const info = "[smallest, largest, default, present value] of a parameter.";
  addFunction(
      service, "getParameterInfo",
      [this](int camera, int which) { return getParameterInfo(camera, which); }, info,
      Argument{"camera", "0: top, 1: bottom."}, parameter);
  addFunction(
      service, "getCameraParameterInfo",
      [this](const std::string& window, int which) {
        return getParameterInfo(windowOf(window).camera, which);
      },
      info, handle, parameter);
}

}  // namespace nao::services
