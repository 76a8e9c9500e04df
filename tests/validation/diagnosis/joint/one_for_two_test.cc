#include "validation/diagnosis/joint/one_for_two.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace nao::validation {
namespace {

std::size_t placeOf(const std::vector<Cause>& causes, const std::string& id) {
  const auto one = std::find_if(causes.begin(), causes.end(),
                                [&](const Cause& cause) { return cause.id == id; });
  return static_cast<std::size_t>(one - causes.begin());
}

// Stops move inwards by up to half a radian here, encoders' zeros either way.
std::vector<Cause> someCauses() {
  std::vector<Cause> causes;
  for (const Cause& cause : jointCauses()) {
    for (const char* id : {"kp_error", "encoder_offset", "ground_tilt.x", "joint_stop.lower"}) {
      if (cause.id == id) causes.push_back(cause);
    }
  }
  for (Cause& cause : causes) {
    cause.free[0].lower = cause.id == "joint_stop.lower" ? 0 : -0.5;
    cause.free[0].upper = 0.5;
  }
  return causes;
}

// A roll's zero that is off by 0.19 on a floor that slopes by 0.19, and a weak servo.
TEST(OneForTwo, IsAStopForAZeroAndASlope) {
  const std::vector<Cause> causes = someCauses();
  const std::size_t gain = placeOf(causes, "kp_error"), stop = placeOf(causes, "joint_stop.lower");
  const CauseList found = {{placeOf(causes, "encoder_offset"), {0.19}},
                           {placeOf(causes, "ground_tilt.x"), {0.19}},
                           {gain, {-0.3}}};
  const std::vector<OneForTwo> all = onesForTwo(found, causes);
  const auto one = std::find_if(all.begin(), all.end(), [&](const OneForTwo& each) {
    return each.place == 0 && each.gone == 1 && each.model.back().cause == stop;
  });
  ASSERT_NE(one, all.end());
  ASSERT_EQ(one->model.size(), 2u);
  EXPECT_EQ(one->model[0].cause, gain);
  EXPECT_EQ(one->model[1].x, std::vector<double>{0.19});
  for (const OneForTwo& each : all) {
    EXPECT_EQ(each.model.size(), 2u);
    EXPECT_GE(each.model.back().x[0], 0) << "no stop moves outwards here, none other is free";
    EXPECT_NE(each.place, each.gone);
  }
}

TEST(OneForTwo, NeedsTwoOfWhichOneHasTwins) {
  const std::vector<Cause> causes = someCauses();
  EXPECT_TRUE(onesForTwo({{placeOf(causes, "encoder_offset"), {0.19}}}, causes).empty());
  EXPECT_TRUE(onesForTwo({{placeOf(causes, "kp_error"), {-0.3}}}, causes).empty());
}

}  // namespace
}  // namespace nao::validation
