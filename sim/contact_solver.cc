#include "sim/contact_solver.h"

#include <algorithm>
#include <cmath>

namespace nao::sim {
namespace {

// Free choice: from 4 to 24 sweeps the deepest overlap in a heap of ten robots stays at 6 to 8 mm.
constexpr int kSweeps = 8;
constexpr double kBounce = 0.05;  // [m/s] free choice: slower approaches do not come back
constexpr double kMending = 0.2;  // free choice: part of a rigid overlap that goes per step

double inertiaOf(const Ball& ball) {
  return ball.inertia_factor * ball.mass * ball.radius * ball.radius;
}

}  // namespace

ContactSolver::Mover& ContactSolver::moverOf(const Side& side) {
  const auto i = static_cast<std::size_t>(side.index);
  if (side.kind == Side::Kind::Robot) {
    Mover& mover = robot_movers_[i];
    if (!mover.active) mover.u = (*robots_)[i]->tree().u;
    mover.active = true;
    return mover;
  }
  Mover& mover = ball_movers_[i];
  if (!mover.active) {
    mover.u.resize(6);
    mover.u << (*balls_)[i].v_W, (*balls_)[i].w_W;
  }
  mover.active = true;
  return mover;
}

void ContactSolver::reachSide(const Side& side, const Vec3& p_W, const Vec3& direction_W,
                              bool turning, double sign, Lever& lever) {
  lever.mover = nullptr;
  if (side.kind == Side::Kind::Fixed) return;
  lever.mover = &moverOf(side);
  const auto i = static_cast<std::size_t>(side.index);
  if (side.kind == Side::Kind::Robot) {
    lever.push.setZero(lever.mover->u.size());
    if (!turning) (*robots_)[i]->addPush(side.body, p_W, sign * direction_W, lever.push);
    return;
  }
  const Vec3 arm = p_W - (*balls_)[i].p_W;
  lever.push.resize(6);
  lever.push.head<3>() = turning ? Vec3(Vec3::Zero()) : Vec3(sign * direction_W);
  lever.push.tail<3>() = turning ? Vec3(sign * direction_W) : Vec3(sign * arm.cross(direction_W));
  const Ball& model = (*models_)[i];
  lever.response = lever.push;
  lever.response.head<3>() /= model.mass;
  lever.response.tail<3>() /= inertiaOf(model);
}

void ContactSolver::reach(const Contact& contact, const Vec3& direction_W, bool turning, Row& row) {
  reachSide(contact.a, contact.p_W, direction_W, turning, 1, row.a);
  reachSide(contact.b, contact.p_W, direction_W, turning, -1, row.b);
  if (row.a.mover && row.a.mover == row.b.mover) {  // a robot against itself
    row.a.push += row.b.push;
    row.b.mover = nullptr;
  }
  row.mobility = row.impulse = 0;
  for (auto [lever, side] : {std::pair{&row.a, &contact.a}, std::pair{&row.b, &contact.b}}) {
    if (!lever->mover) continue;
    if (side->kind == Side::Kind::Robot) {
      lever->response = lever->push;
      (*robots_)[static_cast<std::size_t>(side->index)]->respond(lever->response);
    }
    row.mobility += lever->push.dot(lever->response);
  }
}

void ContactSolver::prepare(const Contact& contact, Rows& rows) {
  const Vec3& n = contact.n_W;
  rows.first_W = n.cross(std::abs(n.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
  rows.second_W = n.cross(rows.first_W);
  reach(contact, n, false, rows.normal);
  reach(contact, rows.first_W, false, rows.first);
  reach(contact, rows.second_W, false, rows.second);
  rows.twist.a.mover = rows.twist.b.mover = nullptr;
  rows.twist.mobility = rows.twist.impulse = 0;
  if (contact.law.torsional_friction > 0) reach(contact, n, true, rows.twist);
  rows.free_speed = speed(rows.normal);
  aim(contact, rows);
}

// The speed of parting to end with.
void ContactSolver::aim(const Contact& contact, Rows& rows) const {
  const ContactLaw& law = contact.law;
  const bool meets = contact.depth > h_ * rows.free_speed;
  rows.softness = 0;
  if (law.restitution > 0 && meets && rows.free_speed < -kBounce) {
    rows.bias = law.restitution * rows.free_speed;
  } else if (law.stiffness > 0 && contact.depth > 0) {
    const double give = law.damping + h_ * law.stiffness;
    rows.softness = 1 / (h_ * give);
    rows.bias = -law.stiffness * contact.depth / give;
  } else {
    rows.bias = -contact.depth / h_ * (contact.depth > 0 ? kMending : 1);
  }
}

double ContactSolver::speed(const Row& row) {
  double sum = 0;
  if (row.a.mover) sum += row.a.push.dot(row.a.mover->u);
  if (row.b.mover) sum += row.b.push.dot(row.b.mover->u);
  return sum;
}

// The impulse after which nothing moves along the row.
double ContactSolver::stopping(const Row& row) {
  return row.mobility > 0 ? row.impulse - speed(row) / row.mobility : 0;
}

void ContactSolver::apply(Row& row, double impulse) {
  const double change = impulse - row.impulse;
  row.impulse = impulse;
  if (row.a.mover) row.a.mover->u += change * row.a.response;
  if (row.b.mover) row.b.mover->u += change * row.b.response;
}

void ContactSolver::sweep(const Contact& contact, Rows& rows) {
  Row& normal = rows.normal;
  if (normal.mobility <= 0) return;
  const double miss = speed(normal) + rows.bias + rows.softness * normal.impulse;
  apply(normal, std::max(0.0, normal.impulse - miss / (normal.mobility + rows.softness)));

  const double most = contact.law.friction * normal.impulse;
  const double first = stopping(rows.first);
  const double second = stopping(rows.second);
  const double length = std::hypot(first, second);
  const double scale = length > most ? most / length : 1;
  apply(rows.first, scale * first);
  apply(rows.second, scale * second);

  const double most_twist = contact.law.torsional_friction * normal.impulse;
  apply(rows.twist, std::clamp(stopping(rows.twist), -most_twist, most_twist));
}

void ContactSolver::solve(const std::vector<RobotBody*>& robots, const std::vector<Ball>& models,
                          std::vector<BallState>& balls, double h) {
  if (contacts_.empty()) return;
  robots_ = &robots;
  models_ = &models;
  balls_ = &balls;
  h_ = h;
  robot_movers_.resize(robots.size());
  ball_movers_.resize(balls.size());
  for (Mover& mover : robot_movers_) mover.active = false;
  for (Mover& mover : ball_movers_) mover.active = false;
  if (rows_.size() < contacts_.size()) rows_.resize(contacts_.size());

  for (std::size_t i = 0; i < contacts_.size(); ++i) prepare(contacts_[i], rows_[i]);
  for (int k = 0; k < kSweeps; ++k) {
    for (std::size_t i = 0; i < contacts_.size(); ++i) sweep(contacts_[i], rows_[i]);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Rows& rows = rows_[i];
    contacts_[i].f_W = (rows.normal.impulse * contacts_[i].n_W + rows.first.impulse * rows.first_W +
                        rows.second.impulse * rows.second_W) /
                       h;
  }
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (!ball_movers_[b].active) continue;
    balls[b].v_W = ball_movers_[b].u.head<3>();
    balls[b].w_W = ball_movers_[b].u.tail<3>();
  }
}

}  // namespace nao::sim
