#include "camera/warp.h"

#include <algorithm>
#include <cmath>

namespace nao::camera {
namespace {

constexpr int kSubExposures = 5;  // of which a blurred row is the mean; free choice

/// The turn by `w` times `time`, to second order: 0.001 rad off at 0.2 rad.
Mat3 turnBy(const Vec3& w, double time) {
  const Vec3 a = time * w;
  Mat3 cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return Mat3::Identity() + cross + 0.5 * cross * cross;
}

/// The time at which a row is exposed, or a part of it, after the picture's [s].
double timeOf(const Turning& turning, double row, int height, int part) {
  return row / height * turning.readout + part * turning.exposure / kSubExposures;
}

int partsOf(const Turning& turning) { return turning.exposure > 0 ? kSubExposures : 1; }

Pixel mixed(const Raster& from, double u, double v) {
  const double x = std::clamp(u - 0.5, 0.0, from.size().width - 1.001);
  const double y = std::clamp(v - 0.5, 0.0, from.size().height - 1.001);
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const Pixel* const above = from.colors(row) + column;
  const Pixel* const below = from.colors(row + 1) + column;
  const int right = static_cast<int>(256 * (x - column) + 0.5);
  return blend(blend(above[0], above[1], right), blend(below[0], below[1], right),
               static_cast<int>(256 * (y - row) + 0.5));
}

}  // namespace

Eigen::Vector2d Warp::distorted(const Eigen::Vector2d& ideal) const {
  const double x = ideal.x(), y = ideal.y();
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (lens_.k1 + r2 * lens_.k2);
  return {x * radial + 2 * lens_.p1 * x * y + lens_.p2 * (r2 + 2 * x * x),
          y * radial + lens_.p1 * (r2 + 2 * y * y) + 2 * lens_.p2 * x * y};
}

// By repetition: the lens moves a point by much less than it lies from the middle.
Eigen::Vector2d Warp::undistorted(const Eigen::Vector2d& shown) const {
  Eigen::Vector2d ideal = shown;
  for (int i = 0; i < 20; ++i) ideal += shown - distorted(ideal);
  return ideal;
}

Eigen::Vector2d Warp::project(const Pinhole& pinhole, const Vec3& p_C) const {
  const Eigen::Vector2d shown = distorted({-p_C.y() / p_C.x(), -p_C.z() / p_C.x()});
  return {pinhole.cx + pinhole.fx * shown.x(), pinhole.cy + pinhole.fy * shown.y()};
}

void Warp::findRays(const Pinhole& lens) {
  if (rays_of_.size == lens.size && rays_of_.fx == lens.fx && rays_of_.fy == lens.fy) return;
  rays_of_ = lens;
  rays_.clear();
  for (int row = 0; row < lens.size.height; ++row) {
    for (int column = 0; column < lens.size.width; ++column) {
      const Eigen::Vector2d ideal =
          undistorted({(column + 0.5 - lens.cx) / lens.fx, (row + 0.5 - lens.cy) / lens.fy});
      rays_.push_back({static_cast<float>(ideal.x()), static_cast<float>(ideal.y())});
    }
  }
}

View Warp::wideView(const View& view, const Turning& turning) {
  const Pinhole& lens = view.lens;
  findRays(lens);
  const auto [width, height] = std::pair(lens.size.width, lens.size.height);
  Eigen::AlignedBox2d seen;
  for (int row = 0; row < height; ++row) {
    for (int part = 0; part < partsOf(turning); ++part) {
      const Mat3 turn = turnBy(turning.w_WC_C, timeOf(turning, row, height, part));
      const bool is_end = row == 0 || row == height - 1;
      for (int column = 0; column < width; column += is_end ? 1 : width - 1) {
        const Ray& ray = rays_[static_cast<std::size_t>(row) * width + column];
        const Vec3 d = turn * Vec3(1, -ray.right, -ray.down);
        if (d.x() > 0.1)
          seen.extend(Eigen::Vector2d(-lens.fx * d.y() / d.x(), -lens.fy * d.z() / d.x()));
      }
    }
  }
  // Two pixels to spare on each side; at most twice the picture, however fast it turns.
  const auto margin = [](double reach, double limit) {
    return std::ceil(std::min(reach, limit)) + 2;
  };
  View wide = view;
  wide.lens.cx = margin(-seen.min().x(), width);
  wide.lens.cy = margin(-seen.min().y(), height);
  wide.lens.size = {static_cast<int>(wide.lens.cx + margin(seen.max().x(), width)),
                    static_cast<int>(wide.lens.cy + margin(seen.max().y(), height))};
  return wide;
}

Raster& Warp::warped(const Raster& wide, const View& view, const View& wide_view,
                     const Turning& turning) {
  picture_.reset(view.lens.size);
  for (int row = 0; row < view.lens.size.height; ++row)
    warpRow(wide, view.lens, wide_view.lens, turning, row);
  return picture_;
}

void Warp::warpRow(const Raster& wide, const Pinhole& lens, const Pinhole& wide_lens,
                   const Turning& turning, int row) {
  const int width = lens.size.width;
  const int parts = partsOf(turning);
  sums_.assign(static_cast<std::size_t>(width), {0, 0, 0});
  const Ray* const rays = &rays_[static_cast<std::size_t>(row) * width];
  for (int part = 0; part < parts; ++part) {
    const Mat3 turn = turnBy(turning.w_WC_C, timeOf(turning, row, lens.size.height, part));
    for (int column = 0; column < width; ++column) {
      const Vec3 d = turn * Vec3(1, -rays[column].right, -rays[column].down);
      const double scale = 1 / std::max(d.x(), 0.1);
      const Pixel pixel = mixed(wide, wide_lens.cx - wide_lens.fx * d.y() * scale,
                                wide_lens.cy - wide_lens.fy * d.z() * scale);
      auto& sum = sums_[static_cast<std::size_t>(column)];
      for (int c = 0; c < 3; ++c) sum[c] += pixel >> (8 * c) & 0xff;
    }
  }
  Pixel* const pixels = picture_.colors(row);
  for (int column = 0; column < width; ++column) {
    const auto& sum = sums_[static_cast<std::size_t>(column)];
    const auto mean = [&](int c) {
      return static_cast<std::uint8_t>((sum[c] + parts / 2) / parts);
    };
    pixels[column] = toPixel({mean(0), mean(1), mean(2)});
  }
}

}  // namespace nao::camera
