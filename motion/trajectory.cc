#include "motion/trajectory.h"

#include <algorithm>
#include <cmath>

namespace nao::motion {
namespace {

// A handle with this slope over a third of `interval` (signed), no higher than `rise`.
Handle autoHandle(double slope, double interval, double rise) {
  double dt = interval / 3;
  double dangle = slope * dt;
  if (std::abs(dangle) > std::abs(rise)) {
    const double cut = std::abs(rise) / std::abs(dangle);
    dt *= cut;
    dangle *= cut;
  }
  return {Handle::Kind::BezierAuto, dt, dangle};
}

double bezier(double u, double y0, double y1, double y2, double y3) {
  const double v = 1 - u;
  return v * v * v * y0 + 3 * v * v * u * y1 + 3 * v * u * u * y2 + u * u * u * y3;
}

// The parameter at which a Bezier curve with the abscissas 0, out, 1 - in, 1 reaches x. Those
// abscissas never decrease for out and in within [0, 1], so halving finds it.
double parameterAt(double x, double out, double in) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 48; ++i) {  // to 2^-48 of the piece
    const double middle = (low + high) / 2;
    (bezier(middle, 0, out, 1 - in, 1) < x ? low : high) = middle;
  }
  return (low + high) / 2;
}

constexpr double kThird = 1.0 / 3;

}  // namespace

void setAutoHandles(double start, std::vector<Key>& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double t_left = i == 0 ? 0 : keys[i - 1].time;
    const double y_left = i == 0 ? start : keys[i - 1].angle;
    const bool last = i + 1 == keys.size();
    const double t_right = last ? keys[i].time : keys[i + 1].time;
    const double y_right = last ? keys[i].angle : keys[i + 1].angle;
    const double rise_left = keys[i].angle - y_left;
    const double rise_right = y_right - keys[i].angle;
    const bool monotone = rise_left * rise_right > 0;
    const double slope = monotone ? (y_right - y_left) / (t_right - t_left) : 0;
    keys[i].before = autoHandle(slope, t_left - keys[i].time, rise_left);
    keys[i].after = autoHandle(slope, t_right - keys[i].time, rise_right);
  }
}

Trajectory::Trajectory(double start, const std::vector<Key>& keys) : start_(start) {
  Key left;
  left.angle = start;
  if (!keys.empty()) left.after = autoHandle(0, keys.front().time, 0);
  pieces_.reserve(keys.size());
  for (const Key& key : keys) {
    pieces_.push_back(pieceBetween(left, key));
    left = key;
  }
}

Trajectory::Piece Trajectory::pieceBetween(const Key& left, const Key& right) {
  Piece piece{};
  piece.begin = left.time;
  piece.length = right.time - left.time;
  piece.y0 = left.angle;
  piece.y3 = right.angle;
  piece.hold = left.after.kind == Handle::Kind::Constant;
  if (piece.length <= 0) {
    piece.length = 0;
    return piece;
  }
  const double rise = right.angle - left.angle;
  if (left.after.kind == Handle::Kind::Linear) {
    piece.out = kThird;
    piece.y1 = left.angle + rise * kThird;
  } else {
    piece.out = std::clamp(left.after.dt / piece.length, 0.0, 1.0);
    piece.y1 = left.angle + left.after.dangle;
  }
  if (right.before.kind == Handle::Kind::Linear) {
    piece.in = kThird;
    piece.y2 = right.angle - rise * kThird;
  } else {
    piece.in = std::clamp(-right.before.dt / piece.length, 0.0, 1.0);
    piece.y2 = right.angle + right.before.dangle;
  }
  return piece;
}

double Trajectory::Piece::valueAt(double time) const {
  if (hold) return y0;
  if (length <= 0) return y3;
  const double u = parameterAt((time - begin) / length, out, in);
  return bezier(u, y0, y1, y2, y3);
}

double Trajectory::at(double time) const {
  if (pieces_.empty() || time <= 0) return start_;
  if (time >= duration()) return pieces_.back().y3;
  const auto next = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                     [](double t, const Piece& p) { return t < p.begin; });
  return std::prev(next)->valueAt(time);
}

double Trajectory::duration() const {
  return pieces_.empty() ? 0 : pieces_.back().begin + pieces_.back().length;
}

void Trajectory::archive(Archive& archive) {
  archive.value(start_);
  archive.each(pieces_, [&archive](Piece& piece) {
    for (double* number : {&piece.begin, &piece.length, &piece.out, &piece.in, &piece.y0, &piece.y1,
                           &piece.y2, &piece.y3}) {
      archive.value(*number);
    }
    archive.value(piece.hold);
  });
}

}  // namespace nao::motion
