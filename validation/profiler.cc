#include "validation/profiler.h"

#include <algorithm>
#include <utility>

namespace nao::validation {
namespace {

using sim::Phase;

constexpr double kInterrupted = 5e-3;  // [s] no part of a step takes as long

const std::pair<Phase, const char*> kNames[] = {{Phase::Encoders, "encoders"},
                                                {Phase::Imu, "inertial unit"},
                                                {Phase::FootForces, "foot forces"},
                                                {Phase::Sonar, "sonar"},
                                                {Phase::Touch, "bumpers and touch"},
                                                {Phase::SensorEffects, "effects on sensors"},
                                                {Phase::Touching, "robots and balls touching"},
                                                {Phase::Effects, "effects on drives"},
                                                {Phase::Dynamics, "mass and bias"},
                                                {Phase::Drives, "drives and stops"},
                                                {Phase::Ground, "ground contact"},
                                                {Phase::Solve, "solve"},
                                                {Phase::Kinematics, "kinematics"}};

}  // namespace

Profiler::Profiler() : seconds_(kMotion + 1) {
  constexpr int kLooks = 1000;
  begin();
  const Clock::time_point start = last_;
  for (int i = 0; i < kLooks; ++i) begin();
  reading_ = std::chrono::duration<double>(last_ - start).count() / kLooks;
}

void Profiler::add(std::size_t part) {
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - last_).count();
  if (seconds < kInterrupted) seconds_[part] += std::max(0.0, seconds - reading_);
  last_ = Clock::now();
}

std::vector<Profiler::Part> Profiler::parts() const {
  std::vector<Part> found;
  for (const auto& [phase, name] : kNames) {
    const double seconds = seconds_[static_cast<std::size_t>(phase)];
    if (seconds > 0) found.push_back({name, seconds});
  }
  if (seconds_[kMotion] > 0) found.push_back({"motion and walk engine", seconds_[kMotion]});
  return found;
}

}  // namespace nao::validation
