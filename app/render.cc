// One picture of a world from a given place: what a robot's camera sees, or an eye of one's own.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "app/commands.h"
#include "app/source_paths.h"
#include "camera/color_conversion.h"
#include "camera/eye.h"
#include "camera/ground_truth.h"
#include "core/camera_effects.h"
#include "core/check.h"
#include "core/files.h"
#include "daemon/options.h"
#include "validation/picture_report.h"
#include "validation/png.h"

namespace nao::app {
namespace {

constexpr double kRadPerDeg = M_PI / 180;

struct Arguments {
  std::string world = "worlds/field_2011.yaml";
  std::string robots_dir = "robots";
  std::vector<std::string> robots;
  std::vector<std::string> at;
  std::string posture;
  std::string head;
  std::string robot;
  std::string camera = "CameraTop";
  std::string from;
  std::string fov = "60.9,47.6";
  std::string size = "640x480";
  std::string out = "picture.png";
  std::string depth;
  std::string labels;
  std::string effects;
  bool json = false;
};

std::vector<double> numbersOf(const std::string& option, const std::string& text,
                              std::size_t count) {
  std::vector<double> numbers;
  std::istringstream in(text);
  std::string word;
  char* end = nullptr;
  while (std::getline(in, word, ',')) {
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (word.empty() || *end != '\0') numbers.resize(count + 1);
  }
  if (numbers.size() == count) return numbers;
  throw InputError(option + ": expected " + std::to_string(count) +
                   " numbers with commas, found '" + text + "'");
}

camera::ImageSize sizeOf(const std::string& text) {
  camera::ImageSize size;
  char end = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &end);
  const bool is_good =
      read == 2 && size.width > 0 && size.height > 0 && size.width <= 4096 && size.height <= 4096;
  if (is_good) return size;
  throw InputError("--size: expected WIDTHxHEIGHT of at most 4096x4096, found '" + text + "'");
}

sim::World makeWorld(const Arguments& arguments) {
  const auto model = loadWorldModel(findSourceFile(arguments.world));
  const std::string robots_dir = findSourceFile(arguments.robots_dir);
  std::vector<sim::RobotSetup> setups;
  if (arguments.robots.empty()) {
    for (const RobotPlace& place : model->robots)
      setups.push_back(
          {place.name, loadRobotModel(robots_dir, place.model), place.start, place.team});
  }
  for (const std::string& word : arguments.robots) {
    const daemon::RobotOption robot = daemon::parseRobot(word);
    Pose2 start;
    if (setups.size() < arguments.at.size()) {
      const auto place = numbersOf("--at", arguments.at[setups.size()], 3);
      start = {place[0], place[1], place[2]};
    }
    setups.push_back({robot.name, loadRobotModel(robots_dir, robot.model), start, std::nullopt});
  }
  return {model, setups, std::chrono::milliseconds(2)};
}

void setJoint(const RobotModel& model, const char* name, double angle, JointArray<double>& angles) {
  const auto joint = model.findJoint(name);
  if (!joint) throw InputError("--head: robot " + model.name + " has no joint " + name);
  angles[*joint] = angle;
}

void pose(const Arguments& arguments, sim::World& world) {
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    const sim::RobotSetup& robot = world.robot(i);
    const std::string name =
        arguments.posture.empty() ? robot.model->start_posture : arguments.posture;
    const Posture* posture = robot.model->findPosture(name);
    if (posture == nullptr)
      throw InputError("--posture: robot " + robot.model->name + " has no posture " + name);
    JointArray<double> angles = posture->angle;
    if (!arguments.head.empty()) {
      const auto head = numbersOf("--head", arguments.head, 2);
      setJoint(*robot.model, "HeadYaw", head[0], angles);
      setJoint(*robot.model, "HeadPitch", head[1], angles);
    }
    world.placeRobot(i, robot.start, &angles);
  }
}

camera::CameraPlace findCamera(const Arguments& arguments, const SceneFrame& scene) {
  for (std::size_t r = 0; r < scene.robots.size(); ++r) {
    const SceneFrame::Robot& robot = scene.robots[r];
    if (!arguments.robot.empty() && robot.name != arguments.robot) continue;
    for (std::size_t c = 0; c < robot.model->cameras.size(); ++c) {
      if (robot.model->cameras[c].name == arguments.camera) return {r, c};
    }
    throw InputError("--camera: robot " + robot.name + " has no camera " + arguments.camera);
  }
  throw InputError(arguments.robot.empty()
                       ? "expected a --robot in the world, or --from x,y,z,roll,pitch,yaw"
                       : "--through: there is no robot " + arguments.robot);
}

// The robot with the camera's effects as the user wants them.
std::shared_ptr<const RobotModel> withEffects(const RobotModel& model, std::size_t camera,
                                              const std::string& wanted) {
  RobotModel changed = model;
  CameraEffects& effects = changed.cameras[camera].effects;
  effects = {};
  std::istringstream in(wanted == "none" ? "" : wanted);
  for (std::string word; std::getline(in, word, ',');) {
    const auto effect = findCameraEffect(word);
    if (!effect)
      throw InputError("--effects: there is no effect '" + word + "', expected none or " +
                       cameraEffectNames());
    effects.** effect = true;
  }
  return std::make_shared<const RobotModel>(changed);
}

camera::View outsideView(const Arguments& arguments) {
  const auto from = numbersOf("--from", arguments.from, 6);
  const auto fov = numbersOf("--fov", arguments.fov, 2);
  for (const double angle : fov) {
    if (!(angle >= 1 && angle <= 137)) throw InputError("--fov: expected 1 to 137 degrees");
  }
  camera::View view;
  view.X_WC = translation({from[0], from[1], from[2]});
  view.X_WC.linear() = rotationFromRpy(from[3], from[4], from[5]);
  view.lens = camera::makePinhole(fov[0] * kRadPerDeg, fov[1] * kRadPerDeg, sizeOf(arguments.size));
  return view;
}

std::string ppmOf(const camera::Raster& raster) {
  const camera::Bytes rgb = camera::toBytes(raster, camera::ColorSpace::kRGB);
  return "P6\n" + std::to_string(raster.size().width) + " " + std::to_string(raster.size().height) +
         "\n255\n" + std::string(rgb.begin(), rgb.end());
}

/// A Netpbm picture of 16 bits a pixel.
template <class Values, class Convert>
std::string deepPgmOf(camera::ImageSize size, const Values& values, const Convert& convert) {
  std::string content =
      "P5\n" + std::to_string(size.width) + " " + std::to_string(size.height) + "\n65535\n";
  for (const auto& value : values) {
    const unsigned word = convert(value);
    content += static_cast<char>(word >> 8);
    content += static_cast<char>(word & 0xff);
  }
  return content;
}

void writeTruth(const Arguments& arguments, const camera::GroundTruth& truth) {
  if (!arguments.depth.empty()) {
    writeFile("--depth", arguments.depth, deepPgmOf(truth.size, truth.depths, [](float depth) {
                return static_cast<unsigned>(std::min(depth * 1000 + 0.5F, 65535.0F));
              }));
  }
  if (!arguments.labels.empty()) {
    writeFile("--labels", arguments.labels,
              deepPgmOf(truth.size, truth.labels, [](unsigned label) { return label; }));
  }
}

/// The picture and from where it is taken.
struct Shot {
  std::optional<camera::CameraPlace> place;  // none: an eye of one's own
  camera::View view;
  camera::Raster raster;
};

Shot take(const Arguments& arguments, SceneFrame& scene, camera::Renderer& renderer) {
  Shot shot;
  if (!arguments.from.empty()) {
    shot.view = outsideView(arguments);
    shot.raster = renderer.render(scene, shot.view);
    return shot;
  }
  shot.place = findCamera(arguments, scene);
  SceneFrame::Robot& robot = scene.robots[shot.place->robot];
  if (!arguments.effects.empty())
    robot.model = withEffects(*robot.model, shot.place->camera, arguments.effects);
  shot.view = camera::viewOf(scene, *shot.place, sizeOf(arguments.size));
  camera::Eye eye(*robot.model, shot.place->camera, 0);
  shot.raster = eye.look(scene, *shot.place, shot.view.lens.size, {}, renderer);
  return shot;
}

void render(const Arguments& arguments) {
  sim::World world = makeWorld(arguments);
  pose(arguments, world);
  SceneFrame scene = world.scene();
  camera::Renderer renderer;
  const Shot shot = take(arguments, scene, renderer);
  const bool is_ppm = std::filesystem::path(arguments.out).extension() == ".ppm";
  writeFile("--out", arguments.out,
            is_ppm ? ppmOf(shot.raster) : validation::encodePng(shot.raster));
  const camera::GroundTruth truth = camera::calcGroundTruth(scene, shot.place, shot.view, renderer);
  writeTruth(arguments, truth);
  if (arguments.json) {
    std::printf("%s\n", validation::toJson(shot.raster, shot.view, truth, scene).c_str());
    return;
  }
  std::printf("%s: %dx%d, hash %s\n", arguments.out.c_str(), shot.view.lens.size.width,
              shot.view.lens.size.height, validation::hashOf(shot.raster).c_str());
}

}  // namespace

void addRender(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("render", "Writes one picture of a world, without moving it.");
  command->add_option("--world", arguments->world, "The world, a YAML file.")
      ->capture_default_str();
  command->add_option("--robots-dir", arguments->robots_dir, "Where robots are.")
      ->capture_default_str();
  command->add_option("--robot", arguments->robots,
                      "A robot, as MODEL or NAME=MODEL. Repeat it for more. Default: the world's.");
  command->add_option("--at", arguments->at,
                      "Where the first --robot stands, the second ...: x,y,theta [m, rad].");
  command->add_option("--posture", arguments->posture, "Of all robots. Default: how they start.");
  command->add_option("--head", arguments->head, "yaw,pitch of all heads [rad].");
  command->add_option("--through", arguments->robot, "The robot that looks. Default: the first.");
  command->add_option("--camera", arguments->camera, "Its camera.")->capture_default_str();
  command->add_option(
      "--from", arguments->from,
      "An eye of one's own instead: x,y,z,roll,pitch,yaw [m, rad], looking along x.");
  command->add_option("--fov", arguments->fov, "How wide and high it sees [degrees].")
      ->capture_default_str();
  command->add_option("--effects", arguments->effects,
                      "What the robot's camera does to its pictures, in place of what its file\n"
                      "says: none, or with commas " +
                          cameraEffectNames() + ".");
  command->add_option("--size", arguments->size, "Of the picture [px].")->capture_default_str();
  command->add_option("--out", arguments->out, "FILE.png or FILE.ppm.")->capture_default_str();
  command->add_option("--depth", arguments->depth,
                      "Also how far away things are, to FILE.pgm: 16 bits, millimetres along the\n"
                      "line of sight, 0 for the sky.");
  command->add_option("--labels", arguments->labels,
                      "Also what they are, to FILE.pgm: 16 bits, the labels of --json.");
  command->add_flag("--json", arguments->json, "Tells hash, camera and boxes of things as JSON.");
  command->callback([arguments] { render(*arguments); });
}

}  // namespace nao::app
