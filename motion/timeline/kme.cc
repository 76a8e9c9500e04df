#include "motion/timeline/kme.h"

#include "motion/timeline/motion_text.h"
#include "motion/timeline/pose_rows.h"

namespace nao::motion {
namespace {

constexpr const char* kJoints[] = {"HeadYaw",      "HeadPitch",  "LShoulderPitch", "LShoulderRoll",
                                   "LElbowYaw",    "LElbowRoll", "LHipYawPitch",   "LHipRoll",
                                   "LHipPitch",    "LKneePitch", "LAnklePitch",    "LAnkleRoll",
                                   "RHipYawPitch", "RHipRoll",   "RHipPitch",      "RKneePitch",
                                   "RAnklePitch",  "RAnkleRoll", "RShoulderPitch", "RShoulderRoll",
                                   "RElbowYaw",    "RElbowRoll"};

// Reads one row that begins at `begin` [s] and puts it. @returns when it ends.
double readRow(const MotionText& text, const TextLine& line, double begin, PoseRows& rows) {
  const auto cells = splitAt(line.text, '%');
  if (cells[0] != "play") text.fail(line.number, "expected play%<angles>%<duration>");
  if (cells.size() != rows.columns() + 2) {
    text.fail(line.number, "expected 22 angles and a duration, not " +
                               std::to_string(cells.size() - 1) + " values");
  }
  const double duration = text.number(cells.back(), line.number, "the duration");
  if (duration <= 0) text.fail(line.number, "the duration must be positive");
  for (std::size_t i = 0; i < rows.columns(); ++i) {
    rows.attempt(
        [&] { rows.put(i, begin + duration, text.number(cells[i + 1], line.number, "an angle")); });
  }
  return begin + duration;
}

}  // namespace

Timeline readKme(const std::string& content, const std::string& source, const RobotModel& model) {
  const MotionText text(content, source);
  PoseRows rows(model, source);
  for (const char* joint : kJoints) rows.addColumn(joint, 1);
  double time = 0;
  for (const TextLine& line : text.lines) {
    const auto cells = splitAt(line.text, '%');
    if (cells.empty() || (cells.size() == 1 && cells[0].empty())) continue;
    rows.attempt([&] { time = readRow(text, line, time, rows); });
  }
  return rows.take();
}

}  // namespace nao::motion
