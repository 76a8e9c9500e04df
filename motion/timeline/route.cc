#include "motion/timeline/route.h"

#include "core/check.h"
#include "motion/posture_graph.h"
#include "motion/timeline/motion_text.h"
#include "motion/timeline/pose_rows.h"

namespace nao::motion {
namespace {

struct Route {
  std::string from, to;
  int line_of_to = 1;
  double rest = 1.0;    // [s] a Nao that has sat or lain down is still by then
  double within = 2.0;  // [s] for the slow last glide
};

Route readWords(const MotionText& text) {
  Route route;
  for (const TextLine& line : text.lines) {
    const auto words = wordsOf(line.text.substr(0, line.text.find('#')));
    if (words.empty()) continue;
    const auto time = [&] {
      const double seconds = text.number(words.back(), line.number, "the time");
      if (seconds <= 0) text.fail(line.number, "the time must be positive");
      return seconds;
    };
    if (words.size() == 2 && words[0] == "from") {
      route.from = words[1];
    } else if (words.size() == 2 && words[0] == "to") {
      route.to = words[1];
      route.line_of_to = line.number;
    } else if (words.size() == 2 && words[0] == "rest") {
      route.rest = time();
    } else if (words.size() == 2 && words[0] == "within") {
      route.within = time();
    } else {
      text.fail(line.number, "expected from, to, rest or within, and one value");
    }
  }
  if (route.from.empty() || route.to.empty()) text.fail(1, "expected a line from and a line to");
  return route;
}

// Lays keys one after the other: each joint along a cubic that begins and ends at rest, as the
// posture graph moves it.
class Course {
 public:
  Course(const RobotModel& model, const std::string& source)
      : rows_(model, source), told_(model.jointCount(), -1.0) {
    for (const Actuator& actuator : model.actuators) rows_.addColumn(actuator.name, 1);
  }

  void move(double duration, const std::vector<std::pair<Joint, double>>& angles) {
    for (const auto& [joint, angle] : angles) {
      const std::size_t j = index(joint);
      if (told_[j] >= 0 && told_[j] < time_) rows_.hold(j, time_);
      told_[j] = time_ + duration;
      rows_.put(j, told_[j], angle, PoseRows::Course::Level);
    }
    wait(duration);
  }
  void wait(double duration) { time_ += duration; }

  Timeline take() {
    rows_.lastUntil(time_);
    return rows_.take();
  }

 private:
  PoseRows rows_;
  std::vector<double> told_;  // [s] of each joint's last key; -1: none
  double time_ = 0;           // [s]
};

}  // namespace

Timeline readRoute(const std::string& content, const std::string& source, const RobotModel& model) {
  const MotionText text(content, source);
  const Route route = readWords(text);
  const Posture* posture = model.findPosture(route.to);
  if (posture == nullptr) {
    text.fail(route.line_of_to, "robot " + model.name + " has no posture " + route.to);
  }
  const auto ways = findRoute(model, route.from, posture->family);
  if (!ways) {
    text.fail(route.line_of_to, "robot " + model.name + " has no way from " + route.from + " to " +
                                    posture->family + ", where " + route.to + " is");
  }
  Course course(model, source);
  for (const Way* way : *ways) {
    for (const WayKey& key : way->keys) course.move(key.time, key.angles);
    course.wait(route.rest);
  }
  std::vector<std::pair<Joint, double>> last;
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    last.emplace_back(toJoint(j), posture->angle[j]);
  }
  course.move(route.within, last);
  return course.take();
}

}  // namespace nao::motion
