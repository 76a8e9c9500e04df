#include "motion/timeline/mof.h"

#include <cmath>
#include <set>

#include "motion/timeline/joints_h25.h"
#include "motion/timeline/motion_text.h"
#include "motion/timeline/pose_rows.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr std::size_t kRowOf2013 = 24;  // 22 joints, Int, Dur

// A line that is no row. @returns false if it is one.
bool readWord(const MotionText& text, const std::vector<std::string>& words, int line,
              PoseRows& rows, std::set<std::string>& told) {
  const std::string& word = words[0];
  if (word == "motion_id" || word == "label") return true;
  if (word == "stiffness" || word == "hardness") {
    if (told.insert("stiffness").second) {
      rows.warn(line, "stiffness is not part of a timeline; it stays as it is set");
    }
    return true;
  }
  if (word == "transition") {
    if (words.size() != 4) text.fail(line, "expected transition <from> <to> <label>");
    if (words[1] == words[2]) rows.warn(line, "the motion repeats from here; it is played once");
    return true;
  }
  if (words.size() == kRowOf2013) {
    text.fail(line, "a row of 22 joints is of the years before 2016, whose signs are not known");
  }
  if (words.size() != kHeadArmsLegs.size() + 2) {
    text.fail(line,
              "expected 26 angles, Int and Dur, not " + std::to_string(words.size()) + " values");
  }
  return false;
}

// Reads one row that begins at `begin` [s] and puts it. @returns when it ends.
double readRow(const MotionText& text, const std::vector<std::string>& words, int line,
               double begin, PoseRows& rows) {
  const double duration = text.number(words.back(), line, "Dur");
  const double interpolate = text.number(words[words.size() - 2], line, "Int");
  if (duration <= 0) text.fail(line, "Dur must be positive");
  const double end = begin + duration / 1000;
  const auto readAngle = [&](std::size_t i) {
    const double value = text.number(words[i], line, "an angle");
    const double target = rows.isHand(i) ? value : value * kDegree;
    interpolate != 0 ? rows.put(i, end, target) : rows.jump(i, begin, end, target);
  };
  for (std::size_t i = 0; i < rows.columns(); ++i) {
    if (words[i] == "-" || words[i] == "*") {
      rows.hold(i, end);
    } else {
      rows.attempt([&] { readAngle(i); });
    }
  }
  rows.lastUntil(end);
  return end;
}

}  // namespace

Timeline readMof(const std::string& content, const std::string& source, const RobotModel& model) {
  const MotionText text(content, source);
  PoseRows rows(model, source);
  for (const char* joint : kHeadArmsLegs) rows.addColumn(joint, 1);
  std::set<std::string> told;
  double time = 0;
  for (const TextLine& line : text.lines) {
    const auto words = wordsOf(line.text.substr(0, line.text.find('"')));
    if (words.empty()) continue;
    rows.attempt([&] {
      if (readWord(text, words, line.number, rows, told)) return;
      time = readRow(text, words, line.number, time, rows);
    });
  }
  return rows.take();
}

}  // namespace nao::motion
