#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/models.h"
#include "walk_engine/zmp_gait.h"

namespace nao::walk {
namespace {

/// A gait with the command it writes, on a body that sways.
struct Walker {
  explicit Walker(const std::shared_ptr<const RobotModel>& model)
      : gait(makeZmpGait(model)),
        command{model->findPosture("StandInit")->angle,
                JointArray<double>(model->jointCount(), 1.0)},
        cycle(model->cycle) {}

  void run(int cycles) {
    for (int k = 0; k < cycles; ++k) {
      measured.time += cycle;
      measured.gyroscope = Vec3(0.1 * std::sin(0.3 * k), 0.05 * std::cos(0.2 * k), 0);
      gait->update(measured, command);
    }
  }
  std::vector<unsigned char> save() const {
    std::vector<unsigned char> bytes;
    Archive archive = Archive::saving(bytes);
    gait->archive(archive);
    return bytes;
  }
  void load(const std::vector<unsigned char>& bytes) const {
    Archive archive = Archive::loading(bytes);
    gait->archive(archive);
    EXPECT_TRUE(archive.atEnd());
  }
  std::uint64_t hash() const {
    Archive archive = Archive::hashing();
    gait->archive(archive);
    return archive.hash();
  }

  std::unique_ptr<motion::Gait> gait;
  JointCommand command;
  SensorFrame measured;
  Duration cycle;
};

bool same(const JointArray<double>& a, const JointArray<double>& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

class GaitState : public testing::Test {
 protected:
  void expectSameWayOn(Walker& a, Walker& b) {
    b.command = a.command;
    b.measured = a.measured;
    for (int k = 0; k < 300; ++k) {
      if (k == 150) a.gait->stop();
      if (k == 150) b.gait->stop();
      a.run(1);
      b.run(1);
      ASSERT_TRUE(same(a.command.angle, b.command.angle)) << "cycle " << k;
    }
    EXPECT_EQ(a.hash(), b.hash());
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  Walker walker_{model_};
};

TEST_F(GaitState, ItsListHoldsAllThatDecidesHowItGoesOn) {
  walker_.gait->walkToward(1, 0.3, 0.2, {});
  for (const int cycles : {1, 30, 97, 55}) {  // requested, rising, walking, in another step
    walker_.run(cycles);
    Walker fresh(model_);
    fresh.load(walker_.save());
    Walker original(model_);
    original.gait = walker_.gait->clone();
    original.command = walker_.command;
    original.measured = walker_.measured;
    expectSameWayOn(original, fresh);
  }
}

TEST_F(GaitState, ACloneSharesNothingThatChanges) {
  walker_.gait->walkToward(1, 0, 0, {});
  walker_.run(100);
  const auto clone = walker_.gait->clone();
  Archive before = Archive::hashing();
  clone->archive(before);
  walker_.run(100);
  Archive after = Archive::hashing();
  clone->archive(after);
  EXPECT_EQ(before.hash(), after.hash());
  EXPECT_NE(before.hash(), walker_.hash());
}

TEST_F(GaitState, AnyHiddenBitChangesTheHash) {
  walker_.gait->walkToward(1, 0, 0, {});
  walker_.run(150);
  const std::vector<unsigned char> bytes = walker_.save();
  // The list ends with both pendulums (position, velocity, acceleration, sum of errors), the
  // odometry and the rest of the shoulders.
  const std::size_t numbers = (4 + 4 + 3 + 2) * sizeof(double);
  for (std::size_t i = bytes.size() - numbers; i < bytes.size(); ++i) {
    std::vector<unsigned char> changed = bytes;
    changed[i] ^= 1U;
    Walker other(model_);
    other.load(changed);
    EXPECT_NE(other.hash(), walker_.hash()) << "byte " << i;
  }
}

}  // namespace
}  // namespace nao::walk
