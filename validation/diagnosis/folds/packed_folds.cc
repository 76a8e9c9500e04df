#include "validation/diagnosis/folds/fold_search.h"
#include "validation/diagnosis/joint/packed_verdict.h"

namespace nao::validation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Fold, name, motions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FoldErrors, held_out)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FoldDiagnosis, verdict, folds, before, after, fitted)

NAO_PACKED(FoldDiagnosis)

}  // namespace nao::validation
