#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "motion/limits.h"
#include "motion/timeline/motion_file.h"
#include "motion/timeline/xar.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

namespace fs = std::filesystem;

const std::string kMotions = NAO_SOURCE_DIR "/../shared/motions/";

struct Named {
  std::string name;
  Timeline timeline;
};

// The motion of a file; of a behavior that would have to choose what to play, those of its boxes.
std::vector<Named> timelinesOf(const fs::path& file, const RobotModel& model) {
  std::vector<Named> found;
  try {
    found.push_back({file.filename().string(), loadMotion(file, model)});
  } catch (const InputError& error) {
    if (std::string(error.what()).find("would have to choose") == std::string::npos) return {};
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (BoxTimeline& box : readXarBoxes(text, file.string(), model)) {
      found.push_back({file.filename().string() + " " + box.box, std::move(box.timeline)});
    }
  }
  return found;
}

// What the drives are to hold at the end: the last key of every joint, as far as the joints go.
JointArray<double> targetsOf(const Timeline& timeline, const RobotModel& model,
                             JointArray<double> angle) {
  for (const Curve& curve : timeline.curves) angle[curve.joint] = curve.keys.back().angle;
  clipToLimits(model, allJoints(model), angle);
  return angle;
}

void expectReplay(const Named& motion, const std::shared_ptr<const RobotModel>& model) {
  EngineBench bench(model);
  bench.pose("StandInit");
  const JointArray<double> start = bench.engine.state().command.angle;
  Interpolate request;
  request.curves = motion.timeline.curves;
  request.smooth = false;
  const int cycles = bench.cyclesUntilEnd(bench.post(request), 10000);
  const double cycle = toSeconds(model->cycle);
  EXPECT_NEAR(cycles * cycle, motion.timeline.length, cycle + 1e-9) << motion.name;
  const JointArray<double> wanted = targetsOf(motion.timeline, *model, start);
  const JointArray<double> held = bench.engine.state().command.angle;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    EXPECT_NEAR(held[j], wanted[j], 1e-9) << motion.name << " " << model->actuators[j].name;
  }
}

// On the two Naos these files were made for: with 21 joints, and with hands and wrists.
TEST(Replay, EveryMotionOfOthersTakesItsTimeAndEndsAtItsKeys) {
  if (!fs::exists(kMotions)) GTEST_SKIP() << "no " << kMotions << " here";
  int replayed = 0;
  for (const char* robot : {"nao_h21_v33", "nao_h25_v50"}) {
    const auto model = loadRobotModel(NAO_SOURCE_DIR "/robots", robot);
    for (const auto& entry : fs::recursive_directory_iterator(kMotions)) {
      if (!entry.is_regular_file() || entry.path().extension() == ".md") continue;
      for (const Named& motion : timelinesOf(entry.path(), *model)) {
        expectReplay(motion, model);
        ++replayed;
      }
    }
  }
  EXPECT_GE(replayed, 2 * 19);  // all joint-angle files of the collection
  std::cout << replayed << " timelines replayed\n";
}

}  // namespace
}  // namespace nao::motion
