#include "sim/phase.h"

#include <gtest/gtest.h>

#include <map>

#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

TEST(PhaseWatch, HearsOfEveryPhaseAndChangesNothing) {
  std::map<Phase, int> heard;
  WorldOptions watched(2ms);
  watched.watch = [&heard](Phase phase) { ++heard[phase]; };
  World one(test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, watched);
  World other(test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, 2ms);
  for (World* world : {&one, &other}) {
    for (int k = 0; k < 5; ++k) world->step();
    world->readSensors(0);
  }
  for (const Phase phase : {Phase::Touching, Phase::Effects, Phase::Dynamics, Phase::Drives,
                            Phase::Ground, Phase::Solve, Phase::Kinematics}) {
    EXPECT_EQ(heard[phase], 5);
  }
  for (const Phase phase : {Phase::Encoders, Phase::Imu, Phase::FootForces, Phase::Sonar,
                            Phase::Touch, Phase::SensorEffects}) {
    EXPECT_EQ(heard[phase], 1);
  }
  EXPECT_EQ(one.hash(), other.hash());
}

}  // namespace
}  // namespace nao::sim
