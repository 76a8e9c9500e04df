#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/timeline/timeline.h"

namespace nao::motion {

/// A motion as most teams write it: rows of poses at times, straight lines between (to the
/// first pose as every Trajectory begins). Columns are joints by name; those this robot has not are
/// left out with a warning each. A value at time 0 is reached within kFirstPose or half the time to
/// the next one, since a motion takes time.
class PoseRows {
 public:
  static constexpr double kFirstPose =
      0.02;  // [s] free choice: a motion cycle of NaoQi on V3 to V5

  PoseRows(const RobotModel& model, std::string source);

  /// @returns the number of the column.
  std::size_t addColumn(const std::string& joint, int line);
  std::size_t columns() const { return columns_.size(); }

  /// Whether `value` is an opening, 0 to 1, rather than an angle.
  bool isHand(std::size_t column) const;

  enum class Course { Straight, Level };  // to a value; Level begins and ends with speed 0

  /// The joint is at `value` [rad, or opening of a hand] at `time` [s]. Told twice for a time, the
  /// last word counts.
  void put(std::size_t column, double time, double value, Course course = Course::Straight);

  /// The joint stays where it is until `time` [s]. Before its first value nothing is known of it:
  /// it then moves to that from the beginning on.
  void hold(std::size_t column, double time);

  /// The same, but the joint gets there at once at the beginning of the row and stays.
  void jump(std::size_t column, double begin, double end, double value);

  /// The values that follow stand on this line of the file.
  void atLine(int line) { line_ = line; }

  /// Reads one row; an InputError means that this row is broken and is left out.
  void attempt(const std::function<void()>& read) { builder_.attempt(read); }
  void addBroken(std::string sentence) { builder_.addBroken(std::move(sentence)); }

  void warn(int line, const std::string& sentence);
  void lastUntil(double end) { builder_.lastUntil(end); }

  /// @throws InputError, if something was broken with that, if no column moves a joint of this
  /// robot.
  Timeline take();

 private:
  struct Column {
    std::string name;
    std::optional<Joint> joint;
    std::vector<Key> keys;
  };
  void settleFirstKey(std::vector<Key>& keys) const;

  const RobotModel& model_;
  std::string source_;
  std::vector<Column> columns_;
  int line_ = 1;
  std::optional<int> line_at_zero_;  // of the last value at time 0 or before
  TimelineBuilder builder_;
};

}  // namespace nao::motion
