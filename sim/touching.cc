#include "sim/touching.h"

#include <algorithm>

#include "core/shape_gap.h"

namespace nao::sim {
namespace {

// The shell of a robot: smooth hard plastic. Friction between plastics is 0.3 to 0.5 in tables.
// The stiffness is a free choice: what is left of it at 2 ms is 1 / (h^2 W) for a light arm anyway.
Material shellMaterial() {
  Material material;
  material.friction = 0.4;
  material.stiffness = 100e3;
  return material;
}
const Material kShell = shellMaterial();

using Side = ContactSolver::Side;

// The more slippery of two surfaces decides, and the bouncier.
ContactLaw lawBetween(const Material& a, const Material& b) {
  return {std::max(a.stiffness, b.stiffness), std::max(a.damping, b.damping),
          std::min(a.friction, b.friction), std::max(a.torsional_friction, b.torsional_friction),
          std::max(a.restitution, b.restitution)};
}

Shape sphereOf(const Ball& ball) {
  Shape shape;
  shape.size.x() = ball.radius;
  return shape;
}

bool apart(const CollisionBody::Bound& a, const CollisionBody::Bound& b) {
  const double reach = a.radius + b.radius;
  return (a.p_W - b.p_W).squaredNorm() > reach * reach;
}

}  // namespace

Touching::Solid Touching::solidOf(std::size_t r, std::size_t i, const RobotBody& robot) const {
  const CollisionBody::Solid& solid = solids_[r].solid(i);
  return {{Side::Kind::Robot, static_cast<int>(r), solid.body},
          solid.shape,
          solids_[r].calcPose(i, robot.motion()),
          kShell};
}

// A ball between hard things stays rigid against what does not move, and soft against the rest.
void Touching::touch(const Solid& a, const Solid& b, double margin) {
  const ShapeGap gap = calcShapeGap(a.shape, a.X_WS, b.shape, b.X_WS);
  if (gap.distance > margin) return;
  ContactLaw law = lawBetween(a.material, b.material);
  if (b.side.kind == Side::Kind::Fixed) law.stiffness = 0;
  solver_.add({a.side, b.side, gap.p_W, gap.n_W, -gap.distance, law, Vec3::Zero()});
}

void Touching::findOfRobot(std::size_t r, const RobotBody& robot) {
  for (const CollisionBody::Pair& pair : solids_[r].pairs()) {
    if (!solids_[r].near(pair)) continue;
    touch(solidOf(r, static_cast<std::size_t>(pair.a), robot),
          solidOf(r, static_cast<std::size_t>(pair.b), robot), 0);
  }
}

void Touching::findBetweenRobots(const std::vector<RobotBody*>& robots) {
  for (std::size_t a = 0; a < robots.size(); ++a) {
    for (std::size_t b = a + 1; b < robots.size(); ++b) {
      if (apart(solids_[a].whole(), solids_[b].whole())) continue;
      for (std::size_t i = 0; i < solids_[a].size(); ++i) {
        if (apart(solids_[a].bound(i), solids_[b].whole())) continue;
        for (std::size_t j = 0; j < solids_[b].size(); ++j) {
          if (apart(solids_[a].bound(i), solids_[b].bound(j))) continue;
          touch(solidOf(a, i, *robots[a]), solidOf(b, j, *robots[b]), 0);
        }
      }
    }
  }
}

void Touching::touchGround(std::size_t b, const BallState& ball, double margin) {
  const Ball& model = world_.balls[b];
  const double height = heightAboveGround(model, world_, ball);
  if (height > margin) return;
  ContactLaw law = lawBetween(model.material, world_.ground);
  law.stiffness = 0;
  const Vec3& n = world_.ground_normal;
  const Vec3 p_W = ball.p_W - (model.radius + height) * n;
  solver_.add({{Side::Kind::Ball, static_cast<int>(b), 0}, {}, p_W, n, -height, law, Vec3::Zero()});
}

void Touching::findOfBall(std::size_t b, const std::vector<RobotBody*>& robots,
                          const std::vector<BallState>& balls, double h) {
  const Shape shape = sphereOf(world_.balls[b]);
  const auto solid = [&](std::size_t i, const Shape& sphere) {
    return Solid{{Side::Kind::Ball, static_cast<int>(i), 0},
                 sphere,
                 translation(balls[i].p_W),
                 world_.balls[i].material};
  };
  const double margin = h * balls[b].v_W.norm() + 1e-6;
  const CollisionBody::Bound bound{balls[b].p_W, world_.balls[b].radius + margin};
  touchGround(b, balls[b], margin);
  for (const Obstacle& obstacle : world_.obstacles) {
    touch(solid(b, shape), {{}, obstacle.shape, obstacle.shape.X_BS, obstacle.material}, margin);
  }
  for (std::size_t other = 0; other < b; ++other) {
    const Shape sphere = sphereOf(world_.balls[other]);
    touch(solid(b, shape), solid(other, sphere), margin);
  }
  for (std::size_t r = 0; r < robots.size(); ++r) {
    if (apart(bound, solids_[r].whole())) continue;
    for (std::size_t i = 0; i < solids_[r].size(); ++i) {
      if (!apart(bound, solids_[r].bound(i))) {
        touch(solid(b, shape), solidOf(r, i, *robots[r]), margin);
      }
    }
  }
}

void Touching::step(const std::vector<RobotBody*>& robots, std::vector<BallState>& balls, double h,
                    std::vector<std::vector<ExternalForce>>& on_robots) {
  on_robots.resize(robots.size());
  for (auto& forces : on_robots) forces.clear();
  for (BallState& ball : balls) ball.v_W.z() -= h * world_.gravity;

  solver_.clear();
  for (std::size_t r = 0; r < robots.size(); ++r) {
    solids_[r].update(robots[r]->motion());
    findOfRobot(r, *robots[r]);
  }
  findBetweenRobots(robots);
  for (std::size_t b = 0; b < balls.size(); ++b) findOfBall(b, robots, balls, h);
  solver_.solve(robots, world_.balls, balls, h);

  resting_.assign(balls.size(), false);
  handOut(on_robots);
  for (std::size_t b = 0; b < balls.size(); ++b) {
    moveBall(world_.balls[b], resting_[b], h, balls[b]);
  }
}

void Touching::handOut(std::vector<std::vector<ExternalForce>>& on_robots) {
  for (const ContactSolver::Contact& contact : solver_.contacts()) {
    for (const auto& [side, sign] : {std::pair{contact.a, 1.0}, std::pair{contact.b, -1.0}}) {
      const auto i = static_cast<std::size_t>(side.index);
      if (side.kind == Side::Kind::Robot) {
        on_robots[i].push_back({side.body, contact.p_W, sign * contact.f_W});
      }
    }
    const bool bears = contact.b.kind == Side::Kind::Fixed && !contact.f_W.isZero(0);
    if (bears) resting_[static_cast<std::size_t>(contact.a.index)] = true;
  }
}

void Touching::report(ContactReport& report) const {
  for (const ContactSolver::Contact& contact : solver_.contacts()) {
    for (const auto& [side, sign] : {std::pair{contact.a, 1.0}, std::pair{contact.b, -1.0}}) {
      if (side.kind != Side::Kind::Robot) continue;
      report.forces.push_back({side.index, side.body, contact.p_W, sign * contact.f_W});
    }
  }
}

}  // namespace nao::sim
