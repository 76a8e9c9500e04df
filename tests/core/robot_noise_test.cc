#include <gtest/gtest.h>

#include "core/robot_model.h"

namespace nao {
namespace {

std::shared_ptr<const RobotModel> load(const std::string& name) {
  return loadRobotModel(NAO_SOURCE_DIR "/robots", name);
}

TEST(RobotNoise, KnowsWhyRepeatsOfOneMotionDiffer) {
  const auto nao = load("nao_h21_v33");
  EXPECT_EQ(nao->start_sd, 1e-3);
  ASSERT_FALSE(nao->noise.empty());
  EXPECT_EQ(nao->noise[0].name, "process_noise");
  EXPECT_EQ(nao->noise[0].joints.size(), 12u);  // RHipYawPitch is the left one's motor again
  EXPECT_TRUE(load("nao_h21_v33_ideal")->noise.empty());
  EXPECT_FALSE(load("nao_h25_v60")->noise.empty());
}

}  // namespace
}  // namespace nao
