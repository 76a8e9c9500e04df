#pragma once

#include <optional>
#include <string>

#include "runtime/replayer.h"

namespace nao::validation {

/// How far two worlds are apart at one moment: the largest differences of all robots and balls.
struct Apart {
  double angle = 0;  // [rad] of a hinge
  std::string hinge;
  double command = 0;  // [rad]
  std::string commanded;
  double place = 0;  // [m] of a body or ball
  std::string body;
};
Apart calcApart(runtime::Simulation& one, runtime::Simulation& other);

/// Where two runs part.
struct RunDifference {
  Duration elapsed{};   // the first step after which their states differ
  Apart at_once;        // then; all zero: in what no body shows yet
  Apart later;          // one second after, or at the end
  Duration later_at{};  // when that was
};

/// Does both again, step by step. Nothing: they were the same as long as both go.
/// @throws InputError if their robots or steps do not match.
std::optional<RunDifference> findDifference(runtime::Replayer& one, runtime::Replayer& other);

/// The first input that one has and the other has not, or has otherwise, as a sentence; empty: all
/// are the same.
std::string describeInputDifference(const runtime::Recording& one, const runtime::Recording& other);

/// "nao.LTibia 0.0012 m, hinge nao.LKneePitch 0.003 rad apart".
std::string describe(const Apart& apart);

}  // namespace nao::validation
