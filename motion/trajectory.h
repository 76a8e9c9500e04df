#pragma once

#include <vector>

#include "core/archive.h"
#include "motion/motion_request.h"

namespace nao::motion {

/// Gives each key the handles Choregraphe draws by itself ("bezier auto"): at a key between two
/// others on a rising or falling stretch the slope is that of its neighbours, at an extremum and
/// at the ends it is level. A handle is a third of its interval long, shortened where it would
/// pass the neighbour's value, so the course never overshoots a key. `start` is the value at time
/// 0, before the first key.
void setAutoHandles(double start, std::vector<Key>& keys);

/// The course of one joint through its keys, from `start` at time 0: cubic Bezier pieces in the
/// plane of time and angle. A handle longer than its interval is cut to it, so that time never
/// runs backwards. A key whose outgoing handle is Constant holds its value until the next key.
class Trajectory {
 public:
  Trajectory() = default;  // 0 for ever
  Trajectory(double start, const std::vector<Key>& keys);

  /// The angle at `time` [s] after the start; the ends hold.
  double at(double time) const;

  double duration() const;  // [s]

  void archive(Archive& archive);

 private:
  struct Piece {
    double begin, length;   // [s]
    double out, in;         // handles along time, as parts of `length`, 0 to 1
    double y0, y1, y2, y3;  // the angles of the four control points
    bool hold;              // y0 until the end

    double valueAt(double time) const;
  };
  static Piece pieceBetween(const Key& left, const Key& right);

  double start_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace nao::motion
