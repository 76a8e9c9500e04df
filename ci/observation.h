#pragma once

#include <memory>
#include <string>

#include "ci/expectation.h"
#include "ci/moment.h"

namespace nao::camera {
class Renderer;
}

namespace nao::ci {

/// What one look showed.
struct Observation {
  bool holds = false;
  double off = 0;    // how far from holding, to find the closest; any unit
  std::string seen;  // "at (0.42, 0.01)"; empty: nothing to tell
};

/// Looks whether conditions hold. Simulation thread.
class Observer {
 public:
  Observer();
  ~Observer();

  Observation look(const Condition& condition, const Moment& moment);

 private:
  Observation lookAt(const SeesBall& image, const Moment& moment);

  std::unique_ptr<camera::Renderer> renderer_;  // made when first asked for
};

}  // namespace nao::ci
