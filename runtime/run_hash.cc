#include "runtime/run_hash.h"

#include "runtime/simulation.h"

namespace nao::runtime {

void RunHash::took(const Input& input) { addTo(hash_, input); }

void RunHash::stepped(const Simulation& simulation) {
  SimTime now = simulation.now();
  if (now.time_since_epoch() % kEvery != Duration::zero()) return;
  std::uint64_t state = simulation.hash();
  hash_.value(now);
  hash_.value(state);
}

}  // namespace nao::runtime
