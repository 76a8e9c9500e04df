#include "motion/timeline/kfm.h"

#include <cmath>

#include "motion/timeline/joints_h25.h"
#include "motion/timeline/pose_rows.h"
#include "motion/timeline/text_tree.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kKeep = 20000;  // the team's sign for "no angle"

struct Part {
  const char* name;
  std::size_t joints;
};
constexpr Part kParts[] = {{"headAngles", 2}, {"armsAngles", 12}, {"legsAngles", 12}};

double angleOf(const MotionText& text, const TextTree& value) {
  std::string word = value.word;
  const bool degrees = word.size() > 3 && word.compare(word.size() - 3, 3, "deg") == 0;
  if (degrees) word.resize(word.size() - 3);
  return text.number(word, value.line, "an angle") * (degrees ? kDegree : 1);
}

const TextTree& memberOf(const MotionText& text, const TextTree& tree, const std::string& name) {
  const TextTree* found = tree.find(name);
  if (found == nullptr) text.fail(tree.line, "the key frame lacks its " + name);
  return *found;
}

PoseRows::Course courseOf(const TextTree& frame, PoseRows& rows) {
  const TextTree* type = frame.find("intType");
  if (type == nullptr || type->word == "linear") return PoseRows::Course::Straight;
  if (type->word != "sine") {
    rows.warn(type->line, "the course " + type->word.substr(0, 40) + " is played as sine");
  }
  return PoseRows::Course::Level;
}

void readFrame(const MotionText& text, const TextTree& frame, double time, PoseRows& rows) {
  const PoseRows::Course course = courseOf(frame, rows);
  std::vector<double> angles;
  for (const Part& part : kParts) {
    const TextTree& list = memberOf(text, frame, part.name);
    if (list.items.size() != part.joints) {
      text.fail(list.line, std::string(part.name) + " must have " + std::to_string(part.joints) +
                               " values, not " + std::to_string(list.items.size()));
    }
    for (const TextTree& item : list.items) angles.push_back(angleOf(text, item));
  }
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] == kKeep ? rows.hold(i, time) : rows.put(i, time, angles[i], course);
  }
}

double durationOf(const MotionText& text, const TextTree& frame) {
  const TextTree& word = memberOf(text, frame, "duration");
  const double duration = text.number(word.word, word.line, "the duration");
  if (duration <= 0) text.fail(word.line, "the duration must be positive");
  return duration / 1000;
}

}  // namespace

Timeline readKfm(const std::string& content, const std::string& source, const RobotModel& model) {
  const MotionText text(content, source);
  PoseRows rows(model, source);
  std::vector<std::string> broken;
  const TextTree tree = readTextTree(content, text, broken);
  for (const std::string& sentence : broken) rows.addBroken(sentence);
  const TextTree* frames = tree.find("keyFrames");
  if (frames == nullptr) text.fail(1, "expected keyFrames = [...]");
  for (const char* joint : kHeadArmsLegs) rows.addColumn(joint, 1);
  double time = 0;
  for (const TextTree& frame : frames->items) {
    rows.attempt([&] {
      const double end = time + durationOf(text, frame);
      readFrame(text, frame, end, rows);
      rows.lastUntil(end);
      time = end;
    });
  }
  return rows.take();
}

}  // namespace nao::motion
