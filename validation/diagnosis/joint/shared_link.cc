#include "validation/diagnosis/joint/shared_link.h"

#include <algorithm>

#include "validation/diagnosis/maths/shared_fit.h"

namespace nao::validation {
namespace {

constexpr double kPromising = 0.5;  // of the best look at the link: what is worth a fit

// Whether all that is off may be off by this joint's link.
bool mayBeAt(const JointCrowd& joints, std::size_t link, double critical) {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const bool feels_it = j == link || joints.carries(j, link);
    if (!feels_it && joints.looks()[j].best > critical) return false;
  }
  return joints.looks()[link].best > critical;
}

// In size; its shape is the look's.
SharedLink fitted(JointCrowd& joints, std::size_t link, const LinkLook& look) {
  const FreeNumber& number = joints.causes()[look.cause].free[0];
  SharedLink found{link, look.cause, look.x, 0};
  const auto gains_at = [&](double x) {
    found.x[0] = x;
    return joints.gainsAt(look.cause, found.x, link);
  };
  SharedFit fit(gains_at, number.lower, number.upper);
  fit.narrow(look.x[0]);
  found.x[0] = fit.best();
  found.gain = fit.gain();
  return found;
}

}  // namespace

std::optional<SharedLink> findLink(JointCrowd& joints, double critical) {
  std::optional<SharedLink> best;
  for (std::size_t link = 0; link < joints.size(); ++link) {
    if (!mayBeAt(joints, link, critical)) continue;
    const std::vector<LinkLook>& looks = joints.looks()[link].links;
    double most = 0;
    for (const LinkLook& look : looks) most = std::max(most, look.gain);
    for (const LinkLook& look : looks) {
      if (look.gain < kPromising * most) continue;
      const SharedLink found = fitted(joints, link, look);
      if (!best || found.gain > best->gain) best = found;
    }
  }
  return best;
}

}  // namespace nao::validation
