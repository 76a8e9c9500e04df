#include "validation/recorded/run_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/check.h"

namespace nao::validation {
namespace {

using runtime::Recording;
using runtime::Replayer;
using runtime::Simulation;
using std::chrono_literals::operator""s;

std::string formatted(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

// Keeps the larger of what is known and `size`, not a number being the largest of all.
void note(double size, const std::string& name, double& largest, std::string& named) {
  if (std::isnan(size)) size = HUGE_VAL;
  if (!(size > largest)) return;
  largest = size;
  named = name;
}

double angleBetween(const Mat3& a, const Mat3& b) {
  return Eigen::AngleAxisd(a.transpose() * b).angle();
}

void compareRobots(Simulation& one, Simulation& other, std::size_t robot, Apart& apart) {
  const SceneFrame::Robot a = one.world().scene().robots[robot];
  const SceneFrame::Robot b = other.world().scene().robots[robot];
  const auto commands_a = one.robot(robot).ports()->state.get();
  const auto commands_b = other.robot(robot).ports()->state.get();
  for (std::size_t j = 0; j < a.model->jointCount(); ++j) {
    note(std::abs(commands_a->command.angle[j] - commands_b->command.angle[j]),
         a.name + "." + a.model->actuators[j].name, apart.command, apart.commanded);
  }
  for (std::size_t i = 0; i < a.X_WB.size(); ++i) {
    const Body& body = a.model->bodies[i];
    note((a.X_WB[i].translation() - b.X_WB[i].translation()).norm(), a.name + "." + body.name,
         apart.place, apart.body);
    if (body.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(body.parent);
    const Mat3 turn_a = a.X_WB[parent].linear().transpose() * a.X_WB[i].linear();
    const Mat3 turn_b = b.X_WB[parent].linear().transpose() * b.X_WB[i].linear();
    note(angleBetween(turn_a, turn_b), a.name + "." + a.model->coordinates[i - 1].name, apart.angle,
         apart.hinge);
  }
}

void checkAlike(Replayer& one, Replayer& other) {
  Simulation& a = one.simulation();
  Simulation& b = other.simulation();
  bool alike = a.robotCount() == b.robotCount() && a.stepSize() == b.stepSize() &&
               a.world().scene().balls.size() == b.world().scene().balls.size();
  for (std::size_t i = 0; alike && i < a.robotCount(); ++i) {
    alike = a.robot(i).model().jointCount() == b.robot(i).model().jointCount() &&
            a.robot(i).model().bodies.size() == b.robot(i).model().bodies.size();
  }
  if (!alike) throw InputError("--diff: the two runs have other robots, balls or steps");
}

// "MoveTo of nao at 3.200 s"
std::string described(const Recording::TimedInput& one, const Recording& of) {
  const bool is_worlds = std::holds_alternative<runtime::WorldRequest>(one.input.content);
  return runtime::nameOf(one.input.content) +
         (is_worlds ? "" : " of " + of.start.robots[one.input.robot].name) +
         formatted(" at %.3f s", toSeconds(one.elapsed));
}

std::uint64_t hashOf(const runtime::Input& input) {
  Archive hash = Archive::hashing();
  addTo(hash, input);
  return hash.hash();
}

}  // namespace

Apart calcApart(Simulation& one, Simulation& other) {
  Apart apart;
  for (std::size_t i = 0; i < one.robotCount(); ++i) compareRobots(one, other, i, apart);
  const auto balls_a = one.world().scene().balls;
  const auto balls_b = other.world().scene().balls;
  for (std::size_t i = 0; i < balls_a.size(); ++i) {
    note((balls_a[i].p_W - balls_b[i].p_W).norm(), one.world().model().balls[i].name, apart.place,
         apart.body);
  }
  return apart;
}

std::optional<RunDifference> findDifference(Replayer& one, Replayer& other) {
  checkAlike(one, other);
  while (one.step() && other.step()) {
    if (one.simulation().hash() == other.simulation().hash()) continue;
    RunDifference difference;
    difference.elapsed = one.elapsed();
    difference.at_once = calcApart(one.simulation(), other.simulation());
    one.advanceTo(difference.elapsed + 1s);
    other.advanceTo(one.elapsed());
    one.advanceTo(other.elapsed());
    difference.later = calcApart(one.simulation(), other.simulation());
    difference.later_at = one.elapsed();
    return difference;
  }
  return std::nullopt;
}

std::string describeInputDifference(const Recording& one, const Recording& other) {
  const auto name = [](std::size_t i, const Recording& of) {
    return i < of.inputs.size() ? described(of.inputs[i], of) : std::string("none");
  };
  const std::size_t common = std::min(one.inputs.size(), other.inputs.size());
  std::size_t i = 0;
  while (i < common && hashOf(one.inputs[i].input) == hashOf(other.inputs[i].input)) ++i;
  if (i == one.inputs.size() && i == other.inputs.size()) return {};
  const std::string here = name(i, one);
  const std::string there = name(i, other);
  return "input " + std::to_string(i + 1) + ": " + here +
         (here == there ? " has other values there" : " here, " + there + " there");
}

std::string describe(const Apart& apart) {
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (apart.place > 0) add(apart.body + formatted(" %.3g m", apart.place));
  if (apart.angle > 0) add("hinge " + apart.hinge + formatted(" %.3g rad", apart.angle));
  if (apart.command > 0) add("command " + apart.commanded + formatted(" %.3g rad", apart.command));
  return text.empty() ? "nothing that bodies or commands show yet" : text + " apart";
}

}  // namespace nao::validation
