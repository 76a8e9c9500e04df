#include "motion/timeline/pos.h"

#include <cmath>
#include <map>

#include "motion/timeline/motion_text.h"
#include "motion/timeline/pose_rows.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;

const std::map<std::string, std::string>& jointOfCode() {
  static const std::map<std::string, std::string> names = {{"HY", "HeadYaw"},
                                                           {"HP", "HeadPitch"},
                                                           {"LSP", "LShoulderPitch"},
                                                           {"LSR", "LShoulderRoll"},
                                                           {"LEY", "LElbowYaw"},
                                                           {"LER", "LElbowRoll"},
                                                           {"LWY", "LWristYaw"},
                                                           {"LHYP", "LHipYawPitch"},
                                                           {"LHR", "LHipRoll"},
                                                           {"LHP", "LHipPitch"},
                                                           {"LKP", "LKneePitch"},
                                                           {"LAP", "LAnklePitch"},
                                                           {"LAR", "LAnkleRoll"},
                                                           {"RHR", "RHipRoll"},
                                                           {"RHP", "RHipPitch"},
                                                           {"RKP", "RKneePitch"},
                                                           {"RAP", "RAnklePitch"},
                                                           {"RAR", "RAnkleRoll"},
                                                           {"RSP", "RShoulderPitch"},
                                                           {"RSR", "RShoulderRoll"},
                                                           {"REY", "RElbowYaw"},
                                                           {"RER", "RElbowRoll"},
                                                           {"RWY", "RWristYaw"},
                                                           {"LH", "LHand"},
                                                           {"RH", "RHand"}};
  return names;
}

// The first line of codes; later ones only repeat it for the reader.
std::size_t readCodes(const MotionText& text, PoseRows& rows) {
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    const auto codes = wordsOf(text.lines[i].text);
    if (codes.size() < 2 || codes.back() != "DUR") continue;
    const int line = text.lines[i].number;
    for (std::size_t k = 0; k + 1 < codes.size(); ++k) {
      const auto joint = jointOfCode().find(codes[k]);
      if (joint == jointOfCode().end()) text.fail(line, "unknown joint code " + codes[k]);
      rows.addColumn(joint->second, line);
    }
    return i + 1;
  }
  text.fail(1, "expected a line of joint codes that ends in DUR");
}

// Reads one row that begins at `begin` [s] and puts it. @returns when it ends.
double readRow(const MotionText& text, const TextLine& line, double begin, PoseRows& rows) {
  const auto words = wordsOf(line.text);
  if (words.size() != rows.columns() + 2) {
    text.fail(line.number, "expected " + std::to_string(rows.columns()) +
                               " angles and a duration, not " + std::to_string(words.size() - 1) +
                               " values");
  }
  const double duration = text.number(words.back(), line.number, "the duration");
  if (duration <= 0) text.fail(line.number, "the duration must be positive");
  const double end = begin + duration / 1000;
  for (std::size_t k = 0; k < rows.columns(); ++k) {
    rows.attempt([&] {
      const double value = text.number(words[k + 1], line.number, "an angle");
      rows.put(k, end, rows.isHand(k) ? value : value * kDegree);
    });
  }
  return end;
}

}  // namespace

Timeline readPos(const std::string& content, const std::string& source, const RobotModel& model) {
  const MotionText text(content, source);
  PoseRows rows(model, source);
  double time = 0;
  bool told_of_stiffness = false;
  for (std::size_t i = readCodes(text, rows); i < text.lines.size(); ++i) {
    const TextLine& line = text.lines[i];
    const auto words = wordsOf(line.text);
    if (!words.empty() && words[0] == "$" && !told_of_stiffness) {
      rows.warn(line.number, "stiffness is not part of a timeline; it stays as it is set");
      told_of_stiffness = true;
    }
    if (words.empty() || words[0] != "!") continue;
    rows.attempt([&] { time = readRow(text, line, time, rows); });
  }
  return rows.take();
}

}  // namespace nao::motion
