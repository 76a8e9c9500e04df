// A simulation set back to a snapshot goes on to the last bit as it did the first time.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <ostream>

#include "motion/timeline/xar.h"
#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using motion::MotionOutcome;
using std::chrono_literals::operator""ms;

constexpr char kSetBack[] = "the simulation was set back to a snapshot";

Simulation oneNao(std::uint64_t seed = 0) {
  sim::WorldOptions options(2ms);
  options.seed = seed;
  return {test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, options};
}

motion::RobotPorts& portsOf(Simulation& simulation) { return *simulation.robot(0).ports(); }

void post(Simulation& simulation, motion::MotionRequest request) {
  ASSERT_TRUE(portsOf(simulation).requests.post(std::move(request)));
}

/// What a stretch of time did: the command of every cycle and the state at its end.
struct Course {
  std::vector<JointCommand> commands;
  std::uint64_t hash = 0;
};

Course go(Simulation& simulation, Duration duration) {
  Course course;
  for (const SimTime end = simulation.now() + duration; simulation.now() < end;) {
    simulation.advanceTo(simulation.now() + 10ms);
    course.commands.push_back(portsOf(simulation).state.get()->command);
  }
  course.hash = simulation.hash();
  return course;
}

void expectSame(const Course& a, const Course& b) {
  ASSERT_EQ(a.commands.size(), b.commands.size());
  for (std::size_t k = 0; k < a.commands.size(); ++k) {
    ASSERT_EQ(std::memcmp(&a.commands[k], &b.commands[k], sizeof(JointCommand)), 0)
        << "cycle " << k;
  }
  EXPECT_EQ(a.hash, b.hash);
}

/// How far [rad] all joints were sent, there and back.
double way(const Course& course) {
  double way = 0;
  for (std::size_t k = 1; k < course.commands.size(); ++k) {
    const JointArray<double>& now = course.commands[k].angle;
    for (std::size_t j = 0; j < now.size(); ++j) {
      way += std::abs(now[j] - course.commands[k - 1].angle[j]);
    }
  }
  return way;
}

const RobotModel& nao() {
  static const auto model = test::robot("nao_h21_v33");
  return *model;
}
Joint joint(const char* name) { return *nao().findJoint(name); }

motion::Interpolate headNods() {
  motion::Interpolate nods;
  for (const char* name : {"HeadYaw", "HeadPitch", "LElbowRoll"}) {
    motion::Curve curve;
    curve.joint = joint(name);
    for (int k = 1; k <= 6; ++k) curve.keys.push_back({0.9 * k, k % 2 ? -0.3 : -0.1, {}, {}});
    nods.curves.push_back(curve);
  }
  return nods;
}

motion::Interpolate timeline() {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\" ?><ChoregrapheProject xar_version=\"3\">"
      "<Box name=\"root\" id=\"-1\"><Timeline enable=\"1\" fps=\"25\" start_frame=\"1\" "
      "end_frame=\"-1\" size=\"200\"><ActuatorList>"
      "<ActuatorCurve actuator=\"HeadYaw\" unit=\"0\"><Key frame=\"30\" value=\"40\"/>"
      "<Key frame=\"120\" value=\"-50\"/></ActuatorCurve>"
      "<ActuatorCurve actuator=\"RShoulderPitch\" unit=\"0\"><Key frame=\"60\" value=\"10\"/>"
      "<Key frame=\"110\" value=\"90\"/></ActuatorCurve></ActuatorList></Timeline></Box>"
      "</ChoregrapheProject>";
  const motion::Timeline read = motion::readXar(text, "test", nao());
  EXPECT_EQ(read.curves.size(), 2u);
  return {read.curves, false, false};
}

/// A robot in the middle of something, and how far its joints at least go in the next 2 s.
struct Moment {
  const char* name;
  std::function<void(Simulation&)> reach;
  double least_way;  // [rad], of all joints together: that this is no robot at rest
};

void PrintTo(const Moment& moment, std::ostream* out) { *out << moment.name; }

void stand(Simulation& simulation) {
  post(simulation, {1, motion::WakeUp{}});
  simulation.advanceTo(SimTime(4000ms));
}

// Where they stop is inside a cycle, so that commands, delays and steps are all under way.
const Moment kMoments[] = {
    {"Walking",
     [](Simulation& simulation) {
       stand(simulation);
       post(simulation, {2, motion::MoveToward{1, 0.2, 0.3, {}}});
       simulation.advanceTo(simulation.now() + 2334ms);
     },
     0.5},
    {"RisingIntoAWalk",
     [](Simulation& simulation) {
       stand(simulation);
       post(simulation, {2, motion::MoveTo{{0.3, 0, 0.5}, {}, {}}});
       simulation.advanceTo(simulation.now() + 114ms);
     },
     0.5},
    {"AngleInterpolation",
     [](Simulation& simulation) {
       stand(simulation);
       post(simulation, {2, headNods()});
       post(simulation, {3, headNods()});  // waits for its joints
       simulation.advanceTo(simulation.now() + 1006ms);
     },
     0.5},
    {"Posture",
     [](Simulation& simulation) {
       stand(simulation);
       post(simulation, {2, motion::GoToPosture{"Sit", 0.5}});
       simulation.advanceTo(simulation.now() + 1502ms);
     },
     0.5},
    {"Timeline",
     [](Simulation& simulation) {
       stand(simulation);
       post(simulation, {2, timeline()});
       simulation.advanceTo(simulation.now() + 2158ms);
     },
     0.5},
    {"Stiffening",
     [](Simulation& simulation) {
       post(simulation, {1, motion::WakeUp{}});
       post(simulation, {2, motion::SetAngles{{joint("HeadYaw")}, {1.0}, {0.05}, false}});
       simulation.advanceTo(SimTime(302ms));
     },
     0.5},
};

class SnapshotAt : public testing::TestWithParam<Moment> {};

TEST_P(SnapshotAt, GoesOnBitByBit) {
  Simulation simulation = oneNao(7);
  GetParam().reach(simulation);
  const auto snapshot = simulation.snapshot();
  const std::uint64_t at_snapshot = simulation.hash();
  const SimTime then = simulation.now();
  const Course first = go(simulation, 2000ms);
  EXPECT_GT(way(first), GetParam().least_way);

  for (int again = 0; again < 2; ++again) {
    simulation.restore(*snapshot);
    EXPECT_EQ(simulation.now(), then);
    EXPECT_EQ(simulation.hash(), at_snapshot);
    expectSame(first, go(simulation, 2000ms));
  }
}

TEST_P(SnapshotAt, GoesOnInAnotherSimulationMadeAlike) {
  Simulation other = oneNao(7);
  Course first;
  std::shared_ptr<const Simulation::Snapshot> snapshot;
  {
    Simulation simulation = oneNao(7);
    GetParam().reach(simulation);
    snapshot = simulation.snapshot();
    first = go(simulation, 2000ms);
  }  // what the snapshot needs of the first it holds itself
  post(other, {1, motion::WakeUp{}});
  other.advanceTo(SimTime(777ms));
  other.restore(*snapshot);
  expectSame(first, go(other, 2000ms));
}

INSTANTIATE_TEST_SUITE_P(Moments, SnapshotAt, testing::ValuesIn(kMoments),
                         [](const auto& moment) { return moment.param.name; });

TEST(Snapshot, ShowsClientsTheSensorsOfItsMoment) {
  Simulation simulation = oneNao();
  stand(simulation);
  const auto snapshot = simulation.snapshot();
  const auto sensors = portsOf(simulation).sensors.get();
  go(simulation, 500ms);
  simulation.restore(*snapshot);
  EXPECT_EQ(portsOf(simulation).sensors.get(), sensors);
  EXPECT_EQ(portsOf(simulation).state.get()->time, sensors->time);
  EXPECT_EQ(simulation.truth().get()->time, simulation.now());
}

TEST(Snapshot, RequestsThatHaveNotEndedFailOverARestore) {
  Simulation simulation = oneNao();
  stand(simulation);
  post(simulation, {2, headNods()});
  simulation.advanceTo(simulation.now() + 500ms);
  const auto snapshot = simulation.snapshot();
  post(simulation, {3, motion::MoveTo{{1, 0, 0}, {}, {}}});
  post(simulation, {4, headNods()});  // waits
  simulation.advanceTo(simulation.now() + 500ms);
  portsOf(simulation).outcomes.drain();
  post(simulation, {5, motion::StopMove{}});  // not even accepted

  simulation.restore(*snapshot);
  const auto outcomes = portsOf(simulation).outcomes.drain();
  ASSERT_EQ(outcomes.size(), 4u);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    EXPECT_EQ(outcomes[i].id, 2 + i);
    EXPECT_EQ(outcomes[i].kind, MotionOutcome::Kind::Failed);
    EXPECT_EQ(outcomes[i].reason, kSetBack);
  }
  EXPECT_EQ(portsOf(simulation).state.get()->last_accepted, 5u);
  EXPECT_EQ(portsOf(simulation).state.get()->set_back, 1u);

  go(simulation, 8000ms);  // the nods of 2 go on and end, and nobody hears of it twice
  EXPECT_TRUE(portsOf(simulation).outcomes.drain().empty());
}

TEST(Snapshot, ARequestOfAnotherCountIsNotTakenForOneOfTheSnapshot) {
  Simulation first = oneNao();
  stand(first);
  post(first, {2, headNods()});
  first.advanceTo(first.now() + 500ms);
  const auto snapshot = first.snapshot();

  Simulation second = oneNao();
  second.restore(*snapshot);
  post(second, {1, motion::WakeUp{}});
  post(second, {2, motion::InterpolateWithSpeed{{joint("LShoulderPitch")}, {0.2}, 0.02}});
  const auto before = portsOf(second).outcomes.drain();
  EXPECT_TRUE(before.empty());
  post(second, {3, motion::Kill{2}});
  go(second, 100ms);
  std::vector<motion::RequestId> ended;
  for (const MotionOutcome& outcome : portsOf(second).outcomes.drain()) ended.push_back(outcome.id);
  EXPECT_EQ(ended, (std::vector<motion::RequestId>{2, 3}));
  EXPECT_EQ(portsOf(second).state.get()->tasks.size(), 1u);  // the nods of the snapshot go on
}

// A mixed world with cycles of 10 and 12 ms, a ball on its way and a push under way.
TEST(Snapshot, HoldsEveryRobotBallAndPush) {
  const auto world = test::flatWorld();
  world->balls.emplace_back();
  Simulation simulation(
      world,
      {{"a", test::robot("nao_h21_v33"), {}}, {"b", test::robot("nao_h25_v60"), {0, -0.8, 0}}},
      2ms);
  const auto both = [&](const motion::MotionRequest& request) {
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_TRUE(simulation.robot(i).ports()->requests.post(request));
    }
  };
  both({1, motion::WakeUp{}});
  simulation.advanceTo(SimTime(4000ms));
  both({2, motion::MoveToward{0.5, 0, 0.5, {}}});
  simulation.advanceTo(SimTime(5000ms));
  simulation.apply(PlaceBall{0, Vec3(0.5, 0.2, 0.3), Vec3(-1, 0, 0)});
  simulation.apply(PushRobot{0, Vec3(5, 0, 0), 300ms});
  simulation.advanceTo(SimTime(5106ms));
  const auto snapshot = simulation.snapshot();
  const Course first = go(simulation, 2000ms);
  const Vec3 ball = simulation.world().scene().balls[0].p_W;
  simulation.restore(*snapshot);
  EXPECT_GT((simulation.world().scene().balls[0].p_W - ball).norm(), 0.1);
  expectSame(first, go(simulation, 2000ms));
  EXPECT_EQ(simulation.world().scene().balls[0].p_W, ball);
}

// In the accuracy modes too, an integrator's own step length included. An arm on its foot: error
// control takes minutes for stiff soles.
TEST(Snapshot, GoesOnBitByBitInEveryMode) {
  for (const auto mode : {sim::Mode::Implicit, sim::Mode::Rk4, sim::Mode::Reference}) {
    sim::WorldOptions options(1ms);
    options.mode = mode;
    Simulation simulation(test::flatWorld(), {{"arm", test::robot("arm"), {}}}, options);
    post(simulation, {1, motion::WakeUp{}});
    simulation.advanceTo(SimTime(303ms));
    post(simulation, {2, motion::SetAngles{{toJoint(0), toJoint(1)}, {0.5, 0.5}, {1, 1}, false}});
    simulation.advanceTo(SimTime(403ms));
    const auto snapshot = simulation.snapshot();
    const Course first = go(simulation, 200ms);
    simulation.restore(*snapshot);
    EXPECT_GT(way(first), 0.4);
    SCOPED_TRACE(static_cast<int>(mode));
    expectSame(first, go(simulation, 200ms));
  }
}

TEST(Snapshot, IsNotChangedByWhatComesLater) {
  Simulation simulation = oneNao();
  kMoments[0].reach(simulation);
  const auto snapshot = simulation.snapshot();
  const Course first = go(simulation, 500ms);
  simulation.apply(ResetWorld{});
  go(simulation, 500ms);
  simulation.apply(PlaceRobot{0, {1, 1, 1}});
  simulation.restore(*snapshot);
  expectSame(first, go(simulation, 500ms));
}

TEST(Snapshot, IsKeptByNameUpToALimit) {
  Simulation simulation = oneNao();
  simulation.apply(TakeSnapshot{"start"});
  const std::uint64_t start = simulation.hash();
  go(simulation, 100ms);
  simulation.apply(TakeSnapshot{"later"});
  EXPECT_EQ(simulation.snapshotNames(), (std::vector<std::string>{"later", "start"}));
  simulation.apply(RestoreSnapshot{"start"});
  EXPECT_EQ(simulation.hash(), start);
  EXPECT_EQ(simulation.now(), SimTime{});
  simulation.apply(DropSnapshot{"start"});
  EXPECT_THROW(simulation.apply(RestoreSnapshot{"start"}), InputError);
  EXPECT_THROW(simulation.apply(DropSnapshot{"start"}), InputError);
  for (std::size_t k = 1; k < Simulation::kMostSnapshots; ++k) {
    simulation.apply(TakeSnapshot{std::to_string(k)});
  }
  EXPECT_THROW(simulation.apply(TakeSnapshot{"too many"}), InputError);
  simulation.apply(TakeSnapshot{"later"});  // in place of the one of this name
}

}  // namespace
}  // namespace nao::runtime
