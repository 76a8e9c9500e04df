#include "ci/last_seconds.h"

#include <algorithm>

#include "runtime/ground_truth.h"
#include "validation/film.h"
#include "validation/png.h"

namespace nao::ci {

void LastSeconds::look(runtime::Simulation& simulation,
                       const std::shared_ptr<const SceneFrame>& scene, bool has_failed) {
  const SimTime now = simulation.now();
  if (now > stop_) return;
  if (has_failed && stop_ == SimTime::max()) stop_ = now + kAfterwards;
  keepBeat(simulation, *scene);
  if (now.time_since_epoch() % kStill == Duration::zero()) scenes_.push_back(scene);
  while (!scenes_.empty() && now - scenes_.front()->time > kLength) scenes_.pop_front();
}

void LastSeconds::keepBeat(runtime::Simulation& simulation, const SceneFrame& scene) {
  Beat beat;
  beat.time = toSeconds(scene.time);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const SceneFrame::Robot& robot = scene.robots[i];
    beat.robots.push_back(runtime::calcFloorPose(*robot.model, robot.X_WB));
    const auto& ports = *simulation.robot(i).ports();
    const auto state = ports.state.get();
    const auto sensors = ports.sensors.get();
    if (!state || !sensors) return;  // before the first cycle
    std::vector<double> asked, sensed;
    for (std::size_t j = 0; j < robot.model->jointCount(); ++j) {
      asked.push_back(state->command.angle[j]);
      sensed.push_back(sensors->angle[j]);
    }
    beat.asked.push_back(std::move(asked));
    beat.sensed.push_back(std::move(sensed));
  }
  for (const SceneFrame::Ball& ball : scene.balls) beat.balls.emplace_back(ball.p_W.head<2>());
  beats_.push_back(std::move(beat));
  while (beats_.back().time - beats_.front().time > toSeconds(kLength)) beats_.pop_front();
}

Course LastSeconds::take() const {
  Course course;
  validation::OutsideCamera camera({300, 225});
  for (const auto& scene : scenes_) {
    course.stills.push_back({toSeconds(scene->time),
                             validation::toBase64(validation::encodePng(camera.picture(*scene)))});
  }
  if (beats_.empty() || scenes_.empty()) return course;
  const SceneFrame& last = *scenes_.back();
  for (std::size_t i = 0; i < last.robots.size(); ++i) {
    Course::Robot robot{last.robots[i].name, last.robots[i].model->name, {}, {}, {}, {}};
    robot.asked.resize(last.robots[i].model->jointCount());
    robot.sensed.resize(robot.asked.size());
    for (const Beat& beat : beats_) {
      robot.x.push_back(beat.robots[i].x);
      robot.y.push_back(beat.robots[i].y);
      for (std::size_t j = 0; j < robot.asked.size(); ++j) {
        robot.asked[j].push_back(beat.asked[i][j]);
        robot.sensed[j].push_back(beat.sensed[i][j]);
      }
    }
    course.robots.push_back(std::move(robot));
  }
  for (std::size_t b = 0; b < last.balls.size(); ++b) {
    Course::Ball ball{last.world->balls[b].name, {}, {}};
    for (const Beat& beat : beats_) {
      ball.x.push_back(beat.balls[b].x());
      ball.y.push_back(beat.balls[b].y());
    }
    course.balls.push_back(std::move(ball));
  }
  for (const Beat& beat : beats_) course.time.push_back(beat.time);
  return course;
}

}  // namespace nao::ci
