#include "validation/diagnosis/jobs/kept_runs.h"
#include "validation/diagnosis/jobs/packed_as.h"

namespace nao::validation {

NAO_PACKED(long)
NAO_PACKED(double)
NAO_PACKED(std::vector<double>)
NAO_PACKED(WholePool)

}  // namespace nao::validation
