// Processor time of the walk: of each quadratic program a walk asks for, and of a motion tick.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "core/qp_solver.h"
#include "motion/motion_engine.h"
#include "walk_engine/com_planner.h"
#include "walk_engine/zmp_gait.h"

namespace nao {
namespace {

constexpr double kCycle = 0.01;      // [s] of a V3.3
constexpr int kCyclesPerTick = 2;    // of ALMotion's 20 ms
constexpr double kComHeight = 0.26;  // [m]
constexpr int kCyclesOfWalk = 2000;

std::shared_ptr<const RobotModel> model() {
  return loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
}

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Every problem of 20 s of a walk that goes all ways.
std::vector<QpProblem> recordProblems() {
  const auto robot = model();
  const walk::Tuning tuning;
  walk::FootstepPlan plan(tuning, kCycle);
  walk::ComPlanner planner(*robot, tuning, kCycle);
  plan.reset({Pose2{0, 0.05, 0}, Pose2{0, -0.05, 0}}, 0);
  planner.reset(kComHeight, plan.calcZmp(0), 0);
  walk::Goal goal;
  goal.kind = walk::Goal::Kind::Velocity;
  std::vector<QpProblem> problems;
  for (int tick = 1; tick <= kCyclesOfWalk; ++tick) {
    if (tick % 400 == 1) {
      const double turn = tick / 400 * 0.4;
      goal.fractions = {1 - turn, turn - 0.5, turn - 1};
      plan.follow(goal, tick);
    }
    plan.advance(tick, tick + planner.horizon());
    planner.advance(plan, tick, [](std::int64_t) { return Eigen::Vector2d::Zero().eval(); });
    if (tick % kCyclesPerTick == 1) problems.push_back(planner.problem());
  }
  return problems;
}

// Best of three for each, in the order of the walk: each begins where the one before ended.
void solving(benchmark::State& state) {
  const std::vector<QpProblem> problems = recordProblems();
  std::vector<double> best(problems.size(), 1);
  for (auto _ : state) {
    for (int round = 0; round < 3; ++round) {
      QpSolver solver;
      for (std::size_t i = 0; i < problems.size(); ++i) {
        const double start = threadSeconds();
        if (solver.solve(problems[i]).status == QpStatus::Stalled) state.SkipWithError("stalled");
        best[i] = std::min(best[i], threadSeconds() - start);
      }
    }
  }
  double sum = 0;
  for (const double seconds : best) sum += seconds;
  state.counters["mean_us"] = 1e6 * sum / static_cast<double>(best.size());
  state.counters["max_us"] = 1e6 * *std::max_element(best.begin(), best.end());
  state.counters["variables"] = static_cast<double>(problems.front().g.size());
}
BENCHMARK(solving);

// Joints that are where they were told to be.
void motionTick(benchmark::State& state) {
  const auto robot = model();
  motion::MotionEngine engine(robot, walk::makeZmpGait(robot));
  engine.accept({1, motion::WakeUp{}});
  SensorFrame frame;
  frame.angle = robot->findPosture("StandInit")->angle;
  for (FootForces& foot : frame.feet) foot.total = 22;  // [N]
  const auto cycle = [&] {
    frame.time += robot->cycle;
    frame.angle = engine.update(frame).angle;
  };
  for (int k = 0; k < 300; ++k) cycle();
  engine.accept({2, motion::MoveToward{1, 0, 0.3, {}}});
  for (int k = 0; k < 300; ++k) cycle();
  for (auto _ : state) {
    for (int k = 0; k < kCyclesPerTick; ++k) cycle();
  }
  if (!engine.state().move_active) state.SkipWithError("it does not walk");
}
BENCHMARK(motionTick)->MinTime(1);

}  // namespace
}  // namespace nao
BENCHMARK_MAIN();
