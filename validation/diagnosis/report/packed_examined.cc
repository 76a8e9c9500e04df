#include "validation/diagnosis/jobs/packed_as.h"
#include "validation/diagnosis/report/examined_joint.h"

namespace nao::validation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointReplay, joint, rmse, mae, floor, misfit, share, real_sd,
                                   simulated_sd, noise_free_rmse)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointCourse, motion, dt, measured, nominal, extended, floor,
                                   measured_sd, simulated_sd, rival, with_rival)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ExaminedJoint, before, after, course)

NAO_PACKED(ExaminedJoint)

}  // namespace nao::validation
