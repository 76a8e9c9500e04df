// No effect keeps a state of its own over a restore: delays, anchors, heat and random engines go
// back with the rest.
#include <gtest/gtest.h>

#include <cstring>

#include "runtime/simulation.h"
#include "sim/effects/catalogue.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

std::vector<std::string> allEffects() {
  std::vector<std::string> names;
  for (const sim::EffectType& type : sim::standardEffects().types()) names.push_back(type.name);
  return names;
}

class SnapshotWithEffect : public testing::TestWithParam<std::string> {
 protected:
  static std::shared_ptr<const RobotModel> model() {
    auto model = std::make_shared<RobotModel>(*test::robot("nao_h21_v33_ideal"));
    model->effects = {{GetParam(), {}, {}, "effect_snapshot_test"}};
    return model;
  }
  static std::unique_ptr<Simulation> simulation() {
    sim::WorldOptions options(2ms);
    options.seed = 5;
    auto simulation = std::make_unique<Simulation>(
        test::flatWorld(), std::vector<sim::RobotSetup>{{"nao", model(), {}}}, options);
    EXPECT_TRUE(simulation->robot(0).ports()->requests.post({1, motion::WakeUp{}}));
    return simulation;
  }

  struct Moment {
    SensorFrame frame;
    std::uint64_t hash = 0;
  };
  static std::vector<Moment> go(Simulation& simulation) {
    std::vector<Moment> course;
    for (int k = 0; k < 50; ++k) {
      simulation.advanceTo(simulation.now() + 10ms);
      course.push_back({*simulation.robot(0).ports()->sensors.get(), simulation.hash()});
    }
    return course;
  }
  static void expectSame(const std::vector<Moment>& a, const std::vector<Moment>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      const SensorFrame& x = a[k].frame;
      const SensorFrame& y = b[k].frame;
      ASSERT_EQ(std::memcmp(&x.angle, &y.angle, sizeof x.angle), 0) << k;
      ASSERT_EQ(std::memcmp(&x.current, &y.current, sizeof x.current), 0) << k;
      ASSERT_EQ(std::memcmp(&x.temperature, &y.temperature, sizeof x.temperature), 0) << k;
      ASSERT_EQ(x.accelerometer, y.accelerometer) << k;
      ASSERT_EQ(x.gyroscope, y.gyroscope) << k;
      ASSERT_EQ(x.angle_x, y.angle_x) << k;
      for (std::size_t foot = 0; foot < 2; ++foot) {
        ASSERT_EQ(x.feet[foot].force, y.feet[foot].force) << k;
      }
      ASSERT_EQ(a[k].hash, b[k].hash) << k;
    }
  }
};

TEST_P(SnapshotWithEffect, GoesOnBitByBit) {
  const auto first = simulation();
  first->advanceTo(SimTime(1236ms));  // on its way up, in the middle of a cycle
  const auto snapshot = first->snapshot();
  const auto course = go(*first);
  first->restore(*snapshot);
  expectSame(course, go(*first));
  const auto other = simulation();
  other->restore(*snapshot);
  expectSame(course, go(*other));
}

INSTANTIATE_TEST_SUITE_P(Effects, SnapshotWithEffect, testing::ValuesIn(allEffects()),
                         [](const auto& effect) { return effect.param; });

}  // namespace
}  // namespace nao::runtime
