#include "motion/timeline/webots_motion.h"

#include <algorithm>

#include "motion/timeline/motion_text.h"
#include "motion/timeline/pose_rows.h"

namespace nao::motion {
namespace {

constexpr const char* kMagic = "#WEBOTS_MOTION";
constexpr std::size_t kBeforeJoints = 2;  // cells of the header, and of a row, before the joints

constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

// The columns of the header; kNoColumn for the fingers that add nothing.
std::vector<std::size_t> readHeader(const MotionText& text, PoseRows& rows) {
  const auto cells = splitAt(text.lines.empty() ? "" : text.lines.front().text, ',');
  if (cells.size() <= kBeforeJoints || cells[0] != kMagic) {
    text.fail(1, "expected the line #WEBOTS_MOTION,V1.0,<names of joints>");
  }
  if (cells[1] != "V1.0") text.fail(1, "expected version V1.0, not " + cells[1].substr(0, 20));
  std::vector<std::size_t> columns;
  for (std::size_t i = kBeforeJoints; i < cells.size(); ++i) {
    const bool finger = cells[i].size() == 9 && cells[i].compare(1, 7, "Phalanx") == 0;
    if (finger && cells[i][8] != '1') {
      columns.push_back(kNoColumn);
    } else {
      columns.push_back(rows.addColumn(finger ? cells[i].substr(0, 1) + "Hand" : cells[i], 1));
    }
  }
  return columns;
}

double readTime(const MotionText& text, const std::string& cell, int line) {
  const auto parts = splitAt(cell, ':');
  if (parts.size() != 3) text.fail(line, "expected a time MM:SS:mmm, not \"" + cell + "\"");
  const double minutes = text.number(parts[0], line, "the minutes");
  const double seconds = text.number(parts[1], line, "the seconds");
  return minutes * 60 + seconds + text.number(parts[2], line, "the milliseconds") / 1000;
}

// Reads one row of poses and puts it, later than `before` [s]. @returns its time.
double readRow(const MotionText& text, const TextLine& line, double before,
               const std::vector<std::size_t>& columns, PoseRows& rows) {
  const auto cells = splitAt(line.text, ',');
  const double time = readTime(text, cells[0], line.number);
  if (time <= before) text.fail(line.number, "the time must be later than that of the row above");
  if (cells.size() < kBeforeJoints) text.fail(line.number, "the row lacks its pose and values");
  const std::size_t values = cells.size() - kBeforeJoints;
  if (values != columns.size()) {
    rows.addBroken(text.place(line.number) + ": this row has " + std::to_string(values) +
                   " values for " + std::to_string(columns.size()) + " joints");
  }
  rows.atLine(line.number);
  for (std::size_t i = 0; i < std::min(values, columns.size()); ++i) {
    const std::string& cell = cells[kBeforeJoints + i];
    if (cell == "*" || columns[i] == kNoColumn) continue;
    rows.attempt(
        [&] { rows.put(columns[i], time, text.number(cell, line.number, "a joint's value")); });
  }
  rows.lastUntil(time);
  return time;
}

}  // namespace

Timeline readWebotsMotion(const std::string& content, const std::string& source,
                          const RobotModel& model) {
  const MotionText text(content, source);
  PoseRows rows(model, source);
  const auto columns = readHeader(text, rows);
  double before = -1;
  for (const TextLine& line : text.lines) {
    const auto cells = splitAt(line.text, ',');
    if (line.number == 1 || cells.empty() || cells[0].empty() || cells[0][0] == '#') continue;
    rows.attempt([&] { before = readRow(text, line, before, columns, rows); });
  }
  return rows.take();
}

}  // namespace nao::motion
