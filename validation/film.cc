#include "validation/film.h"

#include <cmath>
#include <filesystem>

#include "core/check.h"
#include "core/files.h"
#include "validation/png.h"

namespace nao::validation {
namespace {

namespace fs = std::filesystem;

// Where the camera hangs, seen from the floor below the torso, and what it looks at. Free choice:
// all of a Nao with its arms stretched out is in the picture, standing or lying.
const Vec3 kEye(1.25, 0.85, 0.75);           // [m]
constexpr double kMiddle = 0.25;             // [m]
constexpr double kWide = 46 * M_PI / 180;    // [rad] across
constexpr double kHigh = 35.3 * M_PI / 180;  // [rad] so that pixels of 4:3 are square

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

camera::View viewOf(const Vec3& p_WT, camera::ImageSize size) {
  const Vec3 floor(p_WT.x(), p_WT.y(), 0);
  const Vec3 sight = (Vec3(0, 0, kMiddle) - kEye).normalized();
  const Vec3 left = Vec3::UnitZ().cross(sight).normalized();
  camera::View view;
  view.X_WC.linear().col(0) = sight;
  view.X_WC.linear().col(1) = left;
  view.X_WC.linear().col(2) = sight.cross(left);
  view.X_WC.translation() = floor + kEye;
  view.lens = camera::makePinhole(kWide, kHigh, size);
  return view;
}

}  // namespace

const camera::Raster& OutsideCamera::picture(const SceneFrame& scene) {
  return renderer_.render(scene, viewOf(scene.robots.at(0).X_WB.at(0).translation(), size_));
}

Film::Film(const std::string& target, const std::string& encoder) : target_(target) {
  const std::string ending = fs::path(target).extension().string();
  if (ending.empty()) {
    std::error_code failed;
    fs::create_directories(target, failed);
    if (!fs::is_directory(target))
      throw InputError("--video " + target + ": can not make this folder");
    return;
  }
  if (ending != ".mp4") {
    throw InputError("--video " + target + ": expected a file ending in .mp4, or a folder");
  }
  if (!fs::exists(encoder)) {
    throw InputError("--video " + target + ": films are written by " + encoder +
                     ", which is not built without OpenCV's videoio (Debian package "
                     "libopencv-videoio-dev); a folder takes single pictures without it");
  }
  const std::string command = quoted(encoder) + " " + quoted(target) + " " +
                              std::to_string(kSize.width) + " " + std::to_string(kSize.height) +
                              " " + std::to_string(static_cast<int>(kFps));
  pipe_ = ::popen(command.c_str(), "w");
  if (!pipe_) throw InputError("--video " + target + ": " + encoder + " can not be started");
}

Film::~Film() {
  if (pipe_) ::pclose(pipe_);
}

void Film::add(const SceneFrame& scene) {
  const camera::Raster& picture = camera_.picture(scene);
  pipe_ ? addToPipe(picture) : addToFolder(picture);
  ++count_;
}

void Film::addToFolder(const camera::Raster& picture) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%05d.png", count_);
  writeFile("--video", (fs::path(target_) / name).string(), encodePng(picture));
}

void Film::addToPipe(const camera::Raster& picture) {
  for (int y = 0; y < kSize.height; ++y) {
    const auto width = static_cast<std::size_t>(kSize.width);
    const std::size_t written = std::fwrite(picture.colors(y), sizeof(camera::Pixel), width, pipe_);
    if (written != width) throw InputError("--video " + target_ + ": the film can not be written");
  }
}

void Film::close() {
  if (!pipe_) return;
  std::FILE* pipe = pipe_;
  pipe_ = nullptr;
  if (::pclose(pipe) != 0) throw InputError("--video " + target_ + ": the film can not be written");
}

}  // namespace nao::validation
