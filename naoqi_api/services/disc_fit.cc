#include "naoqi_api/services/disc_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace nao::services {
namespace {

using Border = std::vector<BorderPoint>;

constexpr double kOnCircle = 0.8;     // [pixels] the grid's own error is 0.5; the rest: noise
constexpr double kLeastFilled = 0.3;  // of the disc within the picture; free: what may be hidden
constexpr double kMostFilled = 1.2;   // a square fills 1.27 of its largest circle
constexpr std::size_t kLeastPoints = 8;
constexpr double kLeastOnCircle = 0.4;  // of the border; half a disc has 0.6
constexpr std::size_t kStarts = 24;     // of arcs that are tried
constexpr std::array<double, 5> kSpans = {0.25, 0.35, 0.5, 0.65, 0.8};  // of the border

void sortAround(Border& border) {
  double x = 0;
  double y = 0;
  for (const BorderPoint& point : border) {
    x += point.x / static_cast<double>(border.size());
    y += point.y / static_cast<double>(border.size());
  }
  std::sort(border.begin(), border.end(), [x, y](const BorderPoint& a, const BorderPoint& b) {
    return std::atan2(a.y - y, a.x - x) < std::atan2(b.y - y, b.x - x);
  });
}

bool isOn(const Disc& disc, const BorderPoint& point) {
  return std::abs(disc.outside(point.x, point.y)) < kOnCircle;
}

std::size_t countOn(const Disc& disc, const Border& border) {
  return static_cast<std::size_t>(
      std::count_if(border.begin(), border.end(), [&](const auto& p) { return isOn(disc, p); }));
}

// Least squares of x^2 + y^2 + a x + b y + c = 0: exact through three points.
std::optional<Disc> circleThrough(const Border& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd squares(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const BorderPoint& point = points[static_cast<std::size_t>(i)];
    rows.row(i) << point.x, point.y, 1;
    squares[i] = -point.x * point.x - point.y * point.y;
  }
  const auto solver = rows.colPivHouseholderQr();
  if (solver.rank() < 3) return std::nullopt;
  const Vec3 abc = solver.solve(squares);
  const double square = (abc[0] * abc[0] + abc[1] * abc[1]) / 4 - abc[2];
  if (!(square > 0)) return std::nullopt;
  return Disc{-abc[0] / 2, -abc[1] / 2, std::sqrt(square)};
}

// The pixels of a disc that lie within the picture.
double visibleArea(const Disc& disc, int width, int height) {
  double area = 0;
  const auto rowOf = [height](double y) {  // an almost straight border's circle is a huge one
    return static_cast<int>(std::clamp(y, 0.0, height - 1.0));
  };
  const int bottom = rowOf(disc.y + disc.radius);
  for (int row = rowOf(disc.y - disc.radius); row <= bottom; ++row) {
    const double up = row + 0.5 - disc.y;
    const double half = std::sqrt(std::max(0.0, disc.radius * disc.radius - up * up));
    const double left = std::max(0.0, disc.x - half);
    const double right = std::min<double>(width, disc.x + half);
    area += std::max(0.0, right - left);
  }
  return area;
}

bool holds(const Disc& disc, const PatchShape& patch) {
  for (const BorderPoint& point : patch.border) {
    if (disc.outside(point.x, point.y) > 2 * kOnCircle) return false;
  }
  const double filled = patch.count / visibleArea(disc, patch.width, patch.height);
  return filled > kLeastFilled && filled < kMostFilled;
}

/// The best disc so far.
class Best {
 public:
  explicit Best(const PatchShape& patch) : patch_(patch) {}

  void offer(const std::optional<Disc>& disc) {
    if (!disc) return;
    const std::size_t on = countOn(*disc, patch_.border);
    if (on <= on_ || !holds(*disc, patch_)) return;
    on_ = on;
    disc_ = disc;
  }
  const std::optional<Disc>& disc() const { return disc_; }
  std::size_t on() const { return on_; }

 private:
  const PatchShape& patch_;
  std::optional<Disc> disc_;
  std::size_t on_ = 0;
};

void tryArcs(const Border& border, Best& best) {
  const std::size_t count = border.size();
  const auto at = [&](double place) { return border[static_cast<std::size_t>(place) % count]; };
  for (std::size_t k = 0; k < kStarts; ++k) {
    const double start = static_cast<double>(k * count) / kStarts;
    for (const double span : kSpans) {
      const double length = span * static_cast<double>(count);
      best.offer(circleThrough({at(start), at(start + length / 2), at(start + length)}));
    }
  }
}

// Again through all that lies on it, as long as that gains some.
void refine(const Border& border, Best& best) {
  for (std::size_t before = 0; best.on() > before;) {
    before = best.on();
    Border on;
    std::copy_if(border.begin(), border.end(), std::back_inserter(on),
                 [&](const auto& point) { return isOn(*best.disc(), point); });
    best.offer(circleThrough(on));
  }
}

}  // namespace

double Disc::outside(double to_x, double to_y) const {
  return std::hypot(to_x - x, to_y - y) - radius;
}

std::optional<Disc> fitDisc(PatchShape patch) {
  if (patch.border.size() < kLeastPoints) return std::nullopt;
  sortAround(patch.border);
  Best best(patch);
  best.offer(circleThrough(patch.border));
  tryArcs(patch.border, best);
  refine(patch.border, best);
  const double least = kLeastOnCircle * static_cast<double>(patch.border.size());
  return static_cast<double>(best.on()) >= least ? best.disc() : std::nullopt;
}

}  // namespace nao::services
