// Built in place of recording.cc where MuJoCo is not installed.
#include "core/check.h"
#include "tests/hidden/mujoco/recording.h"

namespace nao::hidden {

bool hasMujoco() { return false; }

validation::LogSet recordMujoco(const validation::RecordingPlan&) {
  throw InputError(
      "built without MuJoCo: install libmujoco-dev (scripts/setup) and configure anew");
}

}  // namespace nao::hidden
