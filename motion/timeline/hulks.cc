#include "motion/timeline/hulks.h"

#include <cctype>
#include <map>

#include "motion/timeline/pose_rows.h"
#include "motion/timeline/text_tree.h"

namespace nao::motion {
namespace {

// "left_arm", "shoulder_pitch" -> "LShoulderPitch"
std::string jointName(const std::string& part, const std::string& joint) {
  std::string name = part == "head" ? "Head" : part.rfind("left", 0) == 0 ? "L" : "R";
  bool capital = true;
  for (const char c : joint) {
    if (c != '_') {
      name += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    capital = c == '_';
  }
  return name;
}

class Reader {
 public:
  Reader(const MotionText& text, const RobotModel& model)
      : text_(text), rows_(model, text.source) {}

  Timeline read(const std::string& content) {
    std::vector<std::string> broken;
    const TextTree tree = readTextTree(content, text_, broken);
    for (const std::string& sentence : broken) rows_.addBroken(sentence);
    if (const TextTree* initial = tree.find("initial_positions")) readPose(*initial, 0);
    rows_.attempt([&] { readParts(member(tree, "motion")); });
    return rows_.take();
  }

 private:
  const TextTree& member(const TextTree& tree, const char* name) {
    const TextTree* found = tree.find(name);
    if (found == nullptr) text_.fail(tree.line, std::string("expected a member ") + name);
    return *found;
  }

  void readParts(const TextTree& parts) {
    for (const TextTree& part : parts.items) {
      warnOfConditions(part);
      for (const TextTree& frame : member(part, "keyframes").items) {
        rows_.attempt([&] { readFrame(frame); });
      }
    }
  }

  void warnOfConditions(const TextTree& part) {
    for (const char* name : {"entry_condition", "exit_condition"}) {
      if (const TextTree* condition = part.find(name)) {
        rows_.warn(condition->line, std::string("the ") + name + " is not waited for");
      }
    }
  }

  void readFrame(const TextTree& frame) {
    const TextTree& word = member(frame, "duration");
    const double duration = text_.number(word.word, word.line, "the duration");
    if (duration <= 0) text_.fail(word.line, "the duration must be positive");
    const TextTree& positions = member(frame, "positions");
    time_ += duration;
    readPose(positions, time_);
    rows_.lastUntil(time_);
  }

  void readPose(const TextTree& pose, double time) {
    for (const auto& [part, joints] : pose.members) {
      for (const auto& [joint, value] : joints.members) {
        const std::string name = jointName(part, joint);
        auto column = columns_.find(name);
        if (column == columns_.end()) {
          column = columns_.emplace(name, rows_.addColumn(name, value.line)).first;
        }
        rows_.attempt([&, number = &value] {
          rows_.put(column->second, time, text_.number(number->word, number->line, "a position"));
        });
      }
    }
  }

  const MotionText& text_;
  PoseRows rows_;
  std::map<std::string, std::size_t> columns_;
  double time_ = 0;  // [s]
};

}  // namespace

Timeline readHulks(const std::string& content, const std::string& source, const RobotModel& model) {
  const MotionText text(content, source);
  return Reader(text, model).read(content);
}

}  // namespace nao::motion
