// What UsarSim tells of pictures beyond what a robot can see: depth, labels and boxes, for tests
// and for teaching vision.

#include <cstring>

#include "camera/ground_truth.h"
#include "core/camera_effects.h"
#include "daemon/usar_sim.h"
#include "naoqi_api/call_error.h"

namespace nao::daemon {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

/// The numbers' bytes, the lowest first.
template <class Number, class From>
Value bytesOf(const std::vector<From>& numbers) {
  camera::Bytes bytes(numbers.size() * sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = static_cast<Number>(numbers[i]);
    std::memcpy(&bytes[i * sizeof(Number)], &number, sizeof(Number));
  }
  return Value(std::make_shared<const camera::Bytes>(std::move(bytes)));
}

}  // namespace

void UsarSim::checkCamera(int camera, const SceneFrame& scene) const {
  const auto& cameras = scene.robots[robot_].model->cameras;
  if (camera < 0 || static_cast<std::size_t>(camera) >= cameras.size())
    throw CallError("UsarSim: there is no camera " + std::to_string(camera));
}

void UsarSim::setCameraEffects(int camera, const std::vector<std::string>& effects) {
  checkCamera(camera, *truth_.get());
  CameraEffects on;
  for (const std::string& name : effects) {
    const auto effect = findCameraEffect(name);
    if (!effect) {
      throw CallError("UsarSim: there is no camera effect " + name + ", expected some of " +
                      cameraEffectNames());
    }
    on.** effect = true;
  }
  if (images_) images_->setEffects(camera, on);
}

/// Hands `use` the truth about what a camera of this robot's sees, and the scene.
template <class Use>
Value UsarSim::seen(int camera, int resolution, const Use& use) {
  const auto scene = truth_.get();
  checkCamera(camera, *scene);
  const auto size = camera::resolutionSize(resolution);
  if (!size) throw CallError("UsarSim: there is no resolution " + std::to_string(resolution));
  if (!renderer_) renderer_ = std::make_unique<camera::Renderer>();
  const camera::CameraPlace place{robot_, static_cast<std::size_t>(camera)};
  return use(
      camera::calcGroundTruth(*scene, place, camera::viewOf(*scene, place, *size), *renderer_),
      *scene);
}

Value UsarSim::depthImage(int camera, int resolution) {
  return seen(camera, resolution, [](const camera::GroundTruth& truth, const SceneFrame&) {
    return Value::list({truth.size.width, truth.size.height, bytesOf<float>(truth.depths)});
  });
}

Value UsarSim::labelImage(int camera, int resolution) {
  return seen(camera, resolution, [](const camera::GroundTruth& truth, const SceneFrame&) {
    return Value::list({truth.size.width, truth.size.height, bytesOf<std::uint16_t>(truth.labels)});
  });
}

Value UsarSim::objectBoxes(int camera, int resolution) {
  return seen(camera, resolution, [](const camera::GroundTruth& truth, const SceneFrame& scene) {
    const auto names = camera::labelNames(scene);
    std::vector<Value> boxes;
    for (const camera::LabelBox& box : truth.boxes) {
      boxes.push_back(Value::list({names.at(box.label), box.left, box.top, box.right - box.left,
                                   box.bottom - box.top, box.pixels}));
    }
    return Value::list(boxes);
  });
}

std::vector<std::string> UsarSim::labelNames() const { return camera::labelNames(*truth_.get()); }

void UsarSim::describeTruth(rpc::Service& service) {
  const Argument camera{"camera", "Of this robot. 0: top, 1: bottom."};
  const Argument resolution{"resolution", "0: 160x120, 1: 320x240, 2: 640x480, 3: 1280x960."};
  service
      .method(
          "depthImage", this, &UsarSim::depthImage,
          "How far away along the line of sight [m] what a camera's pinhole sees now is: width, "
          "height, and 4 bytes a pixel, little-endian IEEE 754; 0: sky.",
          camera, resolution)
      .method(
          "labelImage", this, &UsarSim::labelImage,
          "What a camera's pinhole sees now: width, height, and 2 bytes a pixel, little-endian, "
          "the place in labelNames().",
          camera, resolution)
      .method("objectBoxes", this, &UsarSim::objectBoxes,
              "[name, left, top, width, height, visible pixels] of each thing that a camera's "
              "pinhole sees now.",
              camera, resolution)
      .method("labelNames", this, &UsarSim::labelNames,
              "sky, ground, mark, then the names of obstacles, balls and robots.")
      .method("setCameraEffects", this, &UsarSim::setCameraEffects,
              "What a camera does to its pictures from now on, in place of what the robot's file "
              "says.",
              camera,
              Argument{"effects",
                       "Some of response, noise, vignetting, distortion, "
                       "motion_blur, rolling_shutter; none: a pinhole."})
      .method("droppedPictures", this, &UsarSim::droppedPictures,
              "How many pictures of this robot came too late to be drawn; only at a fixed speed.");
}

}  // namespace nao::daemon
