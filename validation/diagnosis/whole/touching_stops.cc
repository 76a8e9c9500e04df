#include "validation/diagnosis/whole/touching_stops.h"

#include <algorithm>

#include "validation/diagnosis/rig/touched_lines.h"

namespace nao::validation {
namespace {

std::vector<std::vector<StopApproach>> approachesTo(const JointEnd& end,
                                                    const WholeSimulator& simulator) {
  std::vector<std::vector<StopApproach>> motions;
  for (const WholeBlock& block : simulator.blocks()) {
    if (block.split != Split::Fit) continue;
    motions.emplace_back();
    for (const std::size_t run : block.runs) {
      const auto of = [&](Joint joint) -> Eigen::VectorXd {
        return simulator.measured()[run].angle.col(static_cast<Eigen::Index>(index(joint)));
      };
      motions.back().push_back({of(end.other), end.left(of(end.stopped))});
    }
  }
  return motions;
}

}  // namespace

void startWhereTouched(PlacedCause& coupled, const WholeSimulator& simulator) {
  if (coupled.joints.size() != 1) return;
  const bool upper = coupled.cause.free[0].parameter == "upper";
  const auto end = endOf(simulator.model(), coupled.joints.front(), upper, simulator.catalogue());
  const std::vector<Joint>& measured = simulator.joints();
  if (!end || std::find(measured.begin(), measured.end(), end->other) == measured.end()) return;
  auto lines = touchedLines(approachesTo(*end, simulator));
  if (!lines.empty()) coupled.cause.together = std::move(lines);
}

}  // namespace nao::validation
