// The shells of a Nao's ankles, which leave its roll less room the more its pitch is bent. The
// table is that of the documentation (NAOqi 2.1.4.13, family/nao_h21/joints_h21_v33.html), written
// here again: nominal models with which the hull is looked for do not have it.
#include "core/robot_model.h"
#include "sim/effects/effect.h"
#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

using Rows = std::vector<CoupledLimit::Row>;

// Of the left ankle: pitch, roll's least and most [rad]. The right one is its mirror image.
const Rows kLeft{{-1.189442, -0.049916, 0.075049}, {-0.840027, -0.179943, 0.169995},
                 {-0.700051, -0.397935, 0.220086}, {-0.449946, -0.397935, 0.768992},
                 {0.100007, -0.397935, 0.768992},  {0.349938, -0.397935, 0.550477},
                 {0.922755, 0, 0.049916}};

Rows mirrored() {
  Rows rows = kLeft;
  for (CoupledLimit::Row& row : rows) row = {row.driver, -row.max, -row.min};
  return rows;
}

void addHull(RobotModel& model, const std::string& side, Rows rows, double inset) {
  const auto pitch = model.findJoint(side + "AnklePitch"),
             roll = model.findJoint(side + "AnkleRoll");
  if (!pitch || !roll) return;
  for (CoupledLimit::Row& row : rows) {
    row.min += inset;
    row.max -= inset;
  }
  model.coupled_limits.push_back({*pitch, *roll, std::move(rows), true, false});
}

}  // namespace

sim::EffectType ankleHull() {
  return {"hidden_ankle_hull",
          "Both ankles' rolls meet their shells, further inside than documented by a number.",
          {{"inset", "rad", 0, 0, -0.1, 0.1, 0}},
          sim::Acts::Once,
          [](const sim::EffectSetup& setup) {
            return sim::changePlan([inset = setup.value("inset")](sim::BodyPlan& plan) {
              addHull(plan.model, "L", kLeft, inset);
              addHull(plan.model, "R", mirrored(), inset);
            });
          }};
}

}  // namespace nao::hidden
