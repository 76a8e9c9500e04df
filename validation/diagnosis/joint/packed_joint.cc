#include "validation/diagnosis/joint/joint_crowd.h"
#include "validation/diagnosis/joint/packed_verdict.h"

namespace nao::validation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointNoise, torque_sd, torque_time, start_sd, quantum, jitter)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NullRecord, gains, remainders)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SharedStep, along, square, nulls)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SharedPart, cause, x, scanned, along, square, gain, lower, upper)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LinkLook, cause, x, gain)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointLooks, nulls, best, square, shared, links)

NAO_PACKED(JointNoise)
NAO_PACKED(SharedStep)
NAO_PACKED(JointLooks)
NAO_PACKED(JointVerdict)

}  // namespace nao::validation
