#include "ci/sentence.h"

#include <cmath>
#include <cstdio>

namespace nao::ci {

std::string shown(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number == 0 ? 0.0 : number);  // no -0
  return text;
}

std::string shown(Duration time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g s", toSeconds(time));
  return text;
}

std::string shownDegrees(double angle) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f degrees", angle * 180 / M_PI);
  return text;
}

}  // namespace nao::ci
