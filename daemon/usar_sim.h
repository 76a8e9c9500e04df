#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "camera/render_queue.h"
#include "camera/renderer.h"
#include "core/latest.h"
#include "core/scene_frame.h"
#include "daemon/robot_loop.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/service.h"

namespace nao::daemon {

/// What a user of the simulator needs beyond the robot: where things really are, time, pushes and
/// places. One service of its own, on every robot's port, because no NaoQi service may know the
/// truth. I/O thread. Poses are in W, metres and radians.
class UsarSim {
 public:
  /// What makes this run different from others.
  struct Chance {
    std::uint64_t seed = 0;
    std::map<std::string, double> draw;
  };

  /// Speaks for robot number `robot` of the loop's simulation.
  UsarSim(RobotLoop& loop, const Latest<SceneFrame>& truth, std::size_t robot, Chance chance);

  /// The robot's pictures, for their effects and losses. Before describe() is used.
  void watch(std::shared_ptr<camera::ImageFeed> images,
             std::shared_ptr<const camera::RenderQueue> pictures) {
    images_ = std::move(images);
    pictures_ = std::move(pictures);
  }

  rpc::Service describe();

  /// Ends the calls whose requests the loop has done; `outcomes` may belong to other ports too.
  void deliver(const std::vector<LoopOutcome>& outcomes);

 private:
  using Pending = rpc::Pending<void>;

  std::vector<std::string> robotNames() const;
  std::vector<float> floorPose() const;
  std::vector<float> floorPoseOf(const std::string& robot) const;
  std::vector<float> torsoPose() const;
  std::vector<float> ballPose() const;
  double time() const;
  float speed() const;
  bool isPaused() const;
  double stepSize() const { return toSeconds(loop_.stepSize()); }
  std::string hash() const;
  std::uint64_t seed() const { return chance_.seed; }
  std::map<std::string, double> draw() const { return chance_.draw; }
  std::vector<std::string> snapshots() const { return loop_.state().get()->snapshots; }

  void describeTruth(rpc::Service& service);
  rpc::Value depthImage(int camera, int resolution);
  rpc::Value labelImage(int camera, int resolution);
  rpc::Value objectBoxes(int camera, int resolution);
  std::vector<std::string> labelNames() const;
  void setCameraEffects(int camera, const std::vector<std::string>& effects);
  std::int64_t droppedPictures() const { return pictures_ ? pictures_->droppedImages() : 0; }
  void checkCamera(int camera, const SceneFrame& scene) const;  // @throws CallError
  template <class Use>
  rpc::Value seen(int camera, int resolution, const Use& use);

  Pending pause();
  Pending resume();
  Pending step(std::int64_t steps);
  Pending setSpeed(double speed);
  Pending reset();
  Pending push(double x, double y, double z, double duration);
  Pending press(const std::string& sensor, double duration);
  Pending pressOn(const std::string& robot, const std::string& sensor, double duration);
  Pending placeRobot(double x, double y, double theta);
  Pending placeBall(double x, double y, double z);
  Pending snapshot(const std::string& name);
  Pending restore(const std::string& name);
  Pending dropSnapshot(const std::string& name);

  Pending ask(decltype(LoopRequest::action) action);
  Pending pressSensor(std::size_t robot, const std::string& sensor, double duration);
  std::size_t findIndex(const std::string& name, const SceneFrame& scene) const;
  const SceneFrame::Robot& find(const std::string& name, const SceneFrame& scene) const;

  RobotLoop& loop_;
  const Latest<SceneFrame>& truth_;
  std::size_t robot_;
  Chance chance_;
  std::uint64_t next_id_;
  std::map<std::uint64_t, Pending> asked_;
  std::shared_ptr<camera::ImageFeed> images_;
  std::shared_ptr<const camera::RenderQueue> pictures_;
  std::unique_ptr<camera::Renderer> renderer_;  // made when first asked for
};

}  // namespace nao::daemon
