#include "validation/diagnosis/joint/one_for_two.h"

namespace nao::validation {
namespace {

// What does nearly the same as a cause at the same number, to either side.
CauseList twinsOf(const Chosen& one, const std::vector<Cause>& causes) {
  CauseList twins;
  for (const std::string& twin : causes[one.cause].twins) {
    for (std::size_t c = 0; c < causes.size(); ++c) {
      if (causes[c].id != twin) continue;
      const FreeNumber& number = causes[c].free[0];
      for (const double x : {one.x[0], -one.x[0]}) {
        if (x >= number.lower && x <= number.upper) twins.push_back({c, {x}});
      }
    }
  }
  return twins;
}

CauseList without(const CauseList& found, std::size_t place, std::size_t other) {
  CauseList kept;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i != place && i != other) kept.push_back(found[i]);
  }
  return kept;
}

}  // namespace

std::vector<OneForTwo> onesForTwo(const CauseList& found, const std::vector<Cause>& causes) {
  std::vector<OneForTwo> all;
  for (std::size_t place = 0; place < found.size(); ++place) {
    for (const Chosen& twin : twinsOf(found[place], causes)) {
      if (has(found, twin.cause)) continue;
      for (std::size_t gone = 0; gone < found.size(); ++gone) {
        if (gone == place) continue;
        all.push_back({place, gone, without(found, place, gone)});
        all.back().model.push_back(twin);
      }
    }
  }
  return all;
}

}  // namespace nao::validation
