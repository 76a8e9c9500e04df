#include "validation/diagnosis/jobs/kept_runs.h"

#include "validation/diagnosis/jobs/packed.h"
#include "validation/log/file_hash.h"

namespace nao::validation {

WholePool KeptRuns::remember(const std::string& what,
                             const std::function<WholePool()>& simulate) const {
  if (!kept_.keeps()) return simulate();
  return unpack<WholePool>(kept_.remember(sha256Of(what), [&] { return pack(simulate()); }));
}

}  // namespace nao::validation
