// A recorded run is done again to the last bit, whole or as far as it came.
#include "runtime/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "core/leds.h"
#include "runtime/database.h"
#include "runtime/recorder.h"
#include "runtime/replayer.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

RunStart twoNaos() {
  const auto world = test::flatWorld();
  RunStart start;
  world->balls.emplace_back();
  start.world = world;
  start.robots = {{"a", test::robot("nao_h21_v33"), {}},
                  {"b", test::robot("nao_h25_v60"), {0, -0.8, 0}}};
  start.seed = 7;
  return start;
}

/// A run with something of everything, a moment at a time. Requests that come while the world
/// stands are taken over there, others in the robot's cycle.
class Story {
 public:
  explicit Story(Simulation& simulation) : simulation_(simulation) {}

  void tell() {
    both(motion::WakeUp{});
    goTo(4s);
    ask(0, motion::MoveToward{1, 0.2, 0.3, {}});
    light(0, "FaceLeds", 0.3f);
    goTo(4334ms);
    simulation_.acceptRequests();
    simulation_.apply(PlaceBall{0, Vec3(0.4, 0, 0.3), Vec3(-1, 0, 0)});
    simulation_.apply(PushRobot{0, Vec3(6, 0, 0), 300ms});
    ask(1, motion::GoToPosture{"Sit", 0.5});
    simulation_.acceptRequests();
    goTo(5506ms);
    simulation_.apply(TakeSnapshot{"there"});
    simulation_.apply(PressSensor{0, "Head/Touch/Front", 200ms});
    light(0, "ChestLeds", 1);
    ask(0, motion::StopMove{});
    goTo(7s);
    simulation_.apply(RestoreSnapshot{"there"});  // time goes back
    ask(0, motion::SetAngles{{toJoint(0)}, {0.5}, {0.2}, false});
    goTo(7s);
    drive(1);
    simulation_.apply(PlaceRobot{0, {0.2, 0.1, 1}});
    goTo(7702ms);
    simulation_.apply(ResetWorld{});
    both(motion::WakeUp{});
    goTo(8506ms);
  }

 private:
  void goTo(Duration time) { simulation_.advanceTo(SimTime(time)); }
  motion::RobotPorts& ports(std::size_t robot) { return *simulation_.robot(robot).ports(); }
  void ask(std::size_t robot, const motion::MotionAction& action) {
    ASSERT_TRUE(ports(robot).requests.post({++last_id_, action}));
  }
  void both(const motion::MotionAction& action) {
    for (const std::size_t robot : {0u, 1u}) ask(robot, action);
  }
  void light(std::size_t robot, const char* leds, float brightness) {
    ASSERT_TRUE(ports(robot).leds.post({leds, brightness}));
  }
  // As a LoLA client does, cycle by cycle.
  void drive(std::size_t robot) {
    const std::size_t joints = simulation_.robot(robot).model().jointCount();
    BodyCommand command{0, JointArray<double>(joints, std::nan("")), JointArray<double>(joints, 1)};
    for (int i = 0; i < 30; ++i) {
      ++command.number;
      command.angle[0] = 0.01 * i;
      ports(robot).body.publish(command);
      simulation_.advanceTo(simulation_.now() + 12ms);
    }
  }

  Simulation& simulation_;
  motion::RequestId last_id_ = 0;
};

/// The state of the whole story at every step, and its recording.
class RecordedStory : public testing::Test {
 protected:
  struct Hashes final : SimulationWatcher {
    std::vector<std::uint64_t> all;
    void took(const Input&) override {}
    void stepped(const Simulation& simulation) override { all.push_back(simulation.hash()); }
  };

  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    hashes_ = new std::vector<std::uint64_t>;
    const RunStart start = twoNaos();
    Simulation simulation = start.makeSimulation();
    Hashes hashes;
    Recorder recorder(file(), start);
    simulation.watch(recorder);
    simulation.watch(hashes);
    Story(simulation).tell();
    recorder.finish(simulation);
    ASSERT_EQ(recorder.failure(), "");
    *hashes_ = hashes.all;
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete hashes_;
  }
  static std::string file() { return folder_->path() + "/run.rec"; }

  static TemporaryFolder* folder_;
  static std::vector<std::uint64_t>* hashes_;  // after every step
};
TemporaryFolder* RecordedStory::folder_ = nullptr;
std::vector<std::uint64_t>* RecordedStory::hashes_ = nullptr;

TEST_F(RecordedStory, IsDoneAgainToTheLastBitFromAnyTime) {
  const Recording recording = readRecording(file());
  EXPECT_TRUE(recording.ended);
  ASSERT_EQ(recording.length(), hashes_->size() * 2ms);
  std::mt19937 random(1);
  for (int i = 0; i < 3; ++i) {
    Replayer replayer(recording);
    std::size_t step = random() % (hashes_->size() - 500) + 1;
    replayer.advanceTo(step * 2ms);
    for (const std::size_t end = step + 400; step < end; ++step) {
      ASSERT_EQ(replayer.simulation().hash(), (*hashes_)[step - 1]) << "step " << step;
      ASSERT_TRUE(replayer.step());
    }
  }
}

TEST_F(RecordedStory, MeetsEveryRecordedState) {
  const Recording recording = readRecording(file());
  ASSERT_GT(recording.states.size(), 90u);
  Replayer replayer(recording);
  replayer.advanceTo(Duration::max());
  replayer.finish();
  EXPECT_FALSE(replayer.departure());
  EXPECT_EQ(replayer.statesMet(), recording.states.size());
}

TEST_F(RecordedStory, PartsWhereTheRobotIsAnother) {
  const Recording recording = readRecording(file());
  RunStart start = recording.start;
  auto other = std::make_shared<RobotModel>(*start.robots[0].model);
  other->bodies[0].mass *= 1.0001;
  start.robots[0].model = other;
  Replayer replayer(recording, start);
  replayer.advanceTo(1s);
  ASSERT_TRUE(replayer.departure());
  EXPECT_EQ(replayer.departure()->elapsed, 100ms);
}

TEST_F(RecordedStory, HoldsEveryInputInItsOrder) {
  const Recording recording = readRecording(file());
  std::vector<std::string> names;
  for (const auto& one : recording.inputs) {
    if (names.empty() || names.back() != nameOf(one.input.content)) {
      names.push_back(nameOf(one.input.content));
    }
  }
  const std::vector<std::string> expected = {
      "WakeUp",       "LedOrder",    "MoveToward", "PlaceBall", "PushRobot",       "GoToPosture",
      "TakeSnapshot", "PressSensor", "LedOrder",   "StopMove",  "RestoreSnapshot", "SetAngles",
      "BodyCommand",  "PlaceRobot",  "ResetWorld", "WakeUp"};
  EXPECT_THAT(names, testing::ElementsAreArray(expected));
}

TEST_F(RecordedStory, CostsLittleRoom) {
  const Recording recording = readRecording(file());
  const double minutes = toSeconds(recording.length()) / 60;
  const auto begin = std::filesystem::file_size(folder_->path() + "/run.rec");
  Database database(file(), Database::Access::Read);
  auto models = database.prepare("SELECT (SELECT sum(length(setup)) FROM robot)");
  ASSERT_TRUE(models.next());
  // The robots themselves come once.
  EXPECT_LT((static_cast<double>(begin) - static_cast<double>(models.integer(0))) / minutes, 2e6);
}

/// A short run whose writer dies as by kill -9, at a moment after `time`.
void recordAndDie(const std::string& file, Duration time) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const RunStart start = twoNaos();
    Simulation simulation = start.makeSimulation();
    Recorder recorder(file, start);
    simulation.watch(recorder);
    if (!simulation.robot(0).ports()->requests.post({1, motion::WakeUp{}})) ::_exit(1);
    simulation.advanceTo(SimTime(time));
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(Recording, OfAKilledRunGoesToItsLastSecond) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/killed.rec";
  recordAndDie(file, 3778ms);
  const Recording recording = readRecording(file);
  EXPECT_FALSE(recording.ended);
  EXPECT_GE(recording.length(), 2778ms);
  Replayer replayer(recording);
  replayer.advanceTo(Duration::max());
  EXPECT_EQ(replayer.elapsed(), recording.length());
  EXPECT_FALSE(replayer.departure());
  EXPECT_EQ(replayer.statesMet(), recording.states.size());
}

std::string complaintOf(const std::string& file) {
  try {
    readRecording(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST_F(RecordedStory, ThatIsCutShortOpensOrSaysWhyNot) {
  const TemporaryFolder folder;
  std::ifstream in(file(), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  for (const std::size_t size : {whole.size() / 2, whole.size() - 5000, std::size_t{3000}}) {
    const std::string cut = folder.write("cut.rec", whole.substr(0, size));
    const std::string complaint = folder.withoutPath(complaintOf(cut));
    EXPECT_EQ(complaint, "cut.rec: database disk image is malformed") << size;
  }
}

TEST_F(RecordedStory, WithABrokenInputSaysSo) {
  const TemporaryFolder folder;
  const std::string broken = folder.path() + "/broken.rec";
  std::filesystem::copy_file(file(), broken);
  Database(broken, Database::Access::Read)
      .run("UPDATE input SET content = zeroblob(length(content)) WHERE number = 3");
  EXPECT_EQ(folder.withoutPath(complaintOf(broken)), "broken.rec: a part is broken");
}

TEST(Recording, ThatIsNoneIsToldInOneSentence) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaintOf(folder.path() + "/none"), folder.path() + "/none: there is no such file");
  EXPECT_EQ(folder.withoutPath(complaintOf(folder.write("text", "something else\n"))),
            "text: file is not a database");
  Database(folder.path() + "/other", Database::Access::Create).run("CREATE TABLE a (b)");
  EXPECT_EQ(folder.withoutPath(complaintOf(folder.path() + "/other")),
            "other: is no recording of a run");
}

TEST(Recording, TakesThePlaceOfOneThatNobodyWrites) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/run.rec";
  { const Recorder first(file, twoNaos()); }
  const Recorder second(file, twoNaos());
  EXPECT_THROW(Recorder(file, twoNaos()), InputError);
}

TEST(Recording, IsNotMadeInPlaceOfAnotherFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("thesis.txt", "years of work");
  EXPECT_THROW(Recorder(file, twoNaos()), InputError);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_THROW(Recorder(folder.path() + "/no/such/folder", twoNaos()), InputError);
}

}  // namespace
}  // namespace nao::runtime
