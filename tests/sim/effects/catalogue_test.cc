#include "sim/effects/catalogue.h"

#include <gtest/gtest.h>

#include "sim/world.h"
#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

using std::chrono_literals::operator""ms;

const EffectType& type(const std::string& name) { return *standardEffects().find(name); }

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const EffectType& one : standardEffects().types()) all.push_back(one.name);
  return all;
}

EffectSetting neutral(const EffectType& type) {
  EffectSetting setting = effect(type.name);
  for (const Parameter& p : type.parameters) setting.parameters[p.name] = p.neutral;
  return setting;
}

// One number for all that can be seen of a Nao for half a second: it stands, moves every joint,
// turns its head and is pushed.
std::uint64_t story(const std::vector<EffectSetting>& effects) {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("nao_h21_v33_ideal"));
  model->effects = effects;
  World world(nao::test::flatWorld(), {{"nao", model, {}}}, WorldOptions(2ms));
  const JointArray<double> start = world.readSensors(0).angle;
  Archive seen = Archive::hashing();
  world.push(0, Vec3(3, 2, 0), 200ms);
  for (int cycle = 0; cycle < 50; ++cycle) {
    JointCommand command{start, JointArray<double>(model->jointCount(), 1.0)};
    for (double& angle : command.angle) angle += 0.002 * cycle;
    command.angle[0] += cycle < 25 ? 0.0 : 0.8;  // faster than the head can
    world.setCommand(0, command);
    for (int i = 0; i < 5; ++i) world.step();
    SensorFrame frame = world.readSensors(0);
    seen.value(frame.angle);
    seen.numbers(frame.accelerometer);
    seen.numbers(frame.gyroscope);
    seen.value(frame.angle_x);
    seen.value(frame.angle_y);
    Vec3 p_WT = world.scene().robots[0].X_WB[0].translation();
    seen.numbers(p_WT);
    for (FootForces& foot : frame.feet) seen.value(foot.force);
  }
  return seen.hash();
}

class EachEffect : public testing::TestWithParam<std::string> {};

TEST_P(EachEffect, DoesNothingWhenNeutralAndSomethingWhenNominal) {
  static const std::uint64_t ideal = story({});
  EXPECT_EQ(story({neutral(type(GetParam()))}), ideal);
  EXPECT_NE(story({effect(GetParam())}), ideal);
}

TEST_P(EachEffect, TellsItsParametersWithinTheirBounds) {
  const EffectType& tested = type(GetParam());
  EXPECT_EQ(tested.summary.back(), '.');
  EXPECT_FALSE(tested.parameters.empty());
  for (const Parameter& p : tested.parameters) {
    EXPECT_LT(p.min, p.max) << p.name;
    EXPECT_GT(p.smallest, 0) << p.name;
    EXPECT_TRUE(p.min <= p.neutral && p.neutral <= p.max) << p.name;
    EXPECT_TRUE(p.min <= p.nominal && p.nominal <= p.max) << p.name;
  }
}

// What it remembers is saved: half a run, restored, goes on as the whole one did.
void expectToGoOnFromASnapshot(const EffectSetting& remembers) {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("nao_h21_v33_ideal"));
  model->effects = {remembers};
  World world(nao::test::flatWorld(), {{"nao", model, {}}}, WorldOptions(2ms));
  const JointArray<double> angle = model->findPosture("StandInit")->angle;
  world.placeRobot(0, {}, &angle);
  const auto goOn = [&] {
    for (int cycle = 0; cycle < 10; ++cycle) {
      JointCommand command{angle, JointArray<double>(model->jointCount(), 1.0)};
      for (double& wanted : command.angle) wanted += 0.01 * cycle;
      world.setCommand(0, command);
      for (int i = 0; i < 5; ++i) world.step();
      world.readSensors(0);
    }
    return world.hash();
  };
  goOn();
  const auto snapshot = world.snapshot();
  const std::uint64_t first = goOn();
  world.restore(*snapshot);
  EXPECT_EQ(goOn(), first);
}

TEST_P(EachEffect, GoesOnFromASnapshotBitByBit) { expectToGoOnFromASnapshot(effect(GetParam())); }

TEST(SensorDelay, OfNoWholeCycleGoesOnFromASnapshotBitByBit) {
  expectToGoOnFromASnapshot(effect("sensor_delay", {{"delay", 0.0173}}));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EachEffect, testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

TEST(EffectChain, BeginsAnewWhenItsRobotIsPutDown) {
  auto model = std::make_shared<RobotModel>(*nao::test::pendulum(0.5, 0.2));
  model->effects = {effect("command_latency", {{"delay", 0.1}})};
  World world(nao::test::flatWorld(), {{"dut", model, {}}}, WorldOptions(2ms));
  const auto run = [&](double angle) {
    world.setCommand(0, {JointArray<double>(1, angle), JointArray<double>(1, 1.0)});
    for (int i = 0; i < 25; ++i) world.step();
    return world.readSensors(0).angle[0];
  };
  run(0.5);
  world.reset();
  EXPECT_NEAR(run(0), 0, 0.02) << "the old command was still on its way";
}

TEST(EffectChain, NamesWhatItDoesNotKnow) {
  const auto model = nao::test::pendulum(1, 1);
  const auto sentence = [&](const EffectSetting& setting) -> std::string {
    try {
      chainOf(*model, {setting});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(sentence({"glue", {}, {}, "body.yaml:7"}).find("body.yaml:7: expected an effect"),
            std::string::npos);
  EXPECT_NE(sentence(effect("backlash", {{"depth", 1}})).find("expected a parameter of backlash"),
            std::string::npos);
  EXPECT_NE(sentence(effect("backlash", {{"width", -1}})).find("expected a number in [0, 0.35]"),
            std::string::npos);
}

}  // namespace
}  // namespace nao::sim::test
