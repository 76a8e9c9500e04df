#include "walk_engine/support.h"

#include <algorithm>

#include "core/frames.h"

namespace nao::walk {
namespace {

using Eigen::Vector2d;

struct Corner {
  Vector2d p;
  int landing = -1;
};

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Andrew's monotone chain: the corners of the convex hull, counter-clockwise.
std::vector<Corner> hull(std::vector<Corner> corners) {
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return a.p.x() != b.p.x() ? a.p.x() < b.p.x() : a.p.y() < b.p.y();
  });
  std::vector<Corner> chain;
  const auto extend = [&chain](const Corner& corner, std::size_t least) {
    while (chain.size() >= least &&
           cross(chain.back().p - chain[chain.size() - 2].p, corner.p - chain.back().p) <= 0) {
      chain.pop_back();
    }
    chain.push_back(corner);
  };
  for (const Corner& corner : corners) extend(corner, 2);
  const std::size_t upper = chain.size() + 1;
  for (auto corner = corners.rbegin() + 1; corner != corners.rend(); ++corner) {
    extend(*corner, upper);
  }
  chain.pop_back();
  return chain;
}

// Each corner nearer to the middle of the sole, by about the margin on every side.
std::vector<Vector2d> drawnIn(const std::vector<Vector2d>& outline, double margin) {
  Vector2d low = outline.front(), high = outline.front();
  for (const Vector2d& p : outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector2d middle = 0.5 * (low + high);
  const Vector2d half = 0.5 * (high - low);
  const Vector2d scale = (half.array() - margin).max(0.001) / half.array();
  std::vector<Vector2d> inner;
  for (const Vector2d& p : outline) inner.push_back(middle + scale.cwiseProduct(p - middle));
  return inner;
}

}  // namespace

Support::Support(const RobotModel& model, double margin) {
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<Corner> corners;
    for (const Vector2d& p : drawnIn(model.feet[i].outline, margin)) corners.push_back({p, -1});
    for (const Corner& corner : hull(corners)) outline_[i].push_back(corner.p);
  }
}

Support::Feet Support::feetAt(const FootstepPlan& plan, std::int64_t tick) {
  Feet feet;
  feet.places = plan.feet();
  int landing = 0;
  for (const PlannedStep& step : plan.steps()) {
    const std::size_t swing = index(step.swing);
    if (tick < step.end()) {
      feet.stands[swing] = tick <= step.lift();
      break;
    }
    feet.places[swing] = step.to;
    feet.landing[swing] = landing++;
  }
  return feet;
}

std::vector<SupportEdge> Support::edges(const Feet& feet, int movable) const {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!feet.stands[i]) continue;
    const int landing = std::min(feet.landing[i], movable - 1);
    for (const Vector2d& p : outline_[i]) {
      const Pose2 corner = compose(feet.places[i], {p.x(), p.y(), 0});
      corners.push_back({{corner.x, corner.y}, landing});
    }
  }
  std::vector<SupportEdge> edges;
  const std::vector<Corner> area = hull(corners);
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Corner& a = area[i];
    const Corner& b = area[(i + 1) % area.size()];
    const Vector2d along = b.p - a.p;
    SupportEdge edge;
    edge.normal = Vector2d(along.y(), -along.x()).normalized();
    edge.offset = edge.normal.dot(a.p);
    edge.step = std::max(a.landing, b.landing);
    edge.share = edge.step < 0 ? 0 : 0.5 * ((a.landing == edge.step) + (b.landing == edge.step));
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace nao::walk
