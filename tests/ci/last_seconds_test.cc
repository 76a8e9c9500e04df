#include "ci/last_seconds.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao::ci {
namespace {

using namespace std::chrono_literals;

// A picture is kept at whole multiples of half a second, and the first beat is none.
TEST(LastSeconds, KeepsNoPictureBeforeTheFirstIsDue) {
  runtime::Simulation simulation(test::flatWorld(), {{"nao", test::robot("nao_h25_v60"), {}}}, 2ms);
  LastSeconds seconds;
  const auto lookAt = [&](Duration time) {
    simulation.advanceTo(SimTime{} + time);
    seconds.look(simulation, std::make_shared<const SceneFrame>(simulation.world().scene()), false);
  };
  lookAt(12ms);
  EXPECT_TRUE(seconds.take().stills.empty());
  lookAt(500ms);
  EXPECT_EQ(seconds.take().stills.size(), 1u);
}

}  // namespace
}  // namespace nao::ci
