#include "core/leds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao {
namespace {

using ::testing::ElementsAre;

std::size_t count(const char* robot, const char* wanted) {
  return findLeds(ledNames(*test::robot(robot)), wanted).size();
}

TEST(Leds, OlderNaosHaveNoneOnTheHead) {  // NAOqi 2.1.4.13 documentation, leds
  for (const char* old : {"nao_h21_v33", "nao_h25_v33"}) {
    EXPECT_EQ(count(old, "AllLeds"), 77U) << old;
    EXPECT_EQ(count(old, "BrainLeds"), 0U) << old;
  }
  for (const char* young : {"nao_h21_v40", "nao_h25_v40", "nao_h25_v50", "nao_h25_v60"}) {
    EXPECT_EQ(count(young, "AllLeds"), 89U) << young;
    EXPECT_EQ(count(young, "BrainLeds"), 12U) << young;
  }
}

TEST(Leds, GroupsAndFoldersNameTheLightsInThem) {
  const char* nao = "nao_h25_v50";
  EXPECT_EQ(count(nao, "FaceLeds"), 48U);
  EXPECT_EQ(count(nao, "LeftFaceLeds"), 24U);
  EXPECT_EQ(count(nao, "EarLeds"), 20U);
  EXPECT_EQ(count(nao, "RightEarLeds"), 10U);
  EXPECT_EQ(count(nao, "ChestLeds"), 3U);
  EXPECT_EQ(count(nao, "FeetLeds"), 6U);
  EXPECT_EQ(count(nao, "LeftFootLeds"), 3U);
  EXPECT_EQ(count(nao, "BrainLedsBack"), 6U);
  EXPECT_EQ(count(nao, "BrainLedsMiddle"), 2U);
  EXPECT_EQ(count(nao, "Face/Led/Red"), 16U);
  EXPECT_EQ(count(nao, "Ears/Led/Left/36Deg"), 1U);
  EXPECT_EQ(count(nao, "Ears/Led/Left/3"), 0U);
  EXPECT_EQ(count(nao, "Tail"), 0U);
}

TEST(Leds, ALightIsFoundWhereItIsListed) {
  const std::vector<std::string> names = ledNames(*test::robot("nao_h25_v50"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_THAT(findLeds(names, names[i]), ElementsAre(i)) << names[i];
  }
}

TEST(Leds, ARobotThatIsNoNaoHasNone) { EXPECT_EQ(count("arm", "AllLeds"), 0U); }

}  // namespace
}  // namespace nao
