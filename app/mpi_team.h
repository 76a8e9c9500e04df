#pragma once

#include <memory>

#include "validation/diagnosis/jobs/team.h"

namespace nao::app {

/// The processes that mpirun (or srun) started with this one; this one alone if neither did. MPI is
/// loaded only if it is needed. @throws InputError if it is, and the program was built without.
std::shared_ptr<const validation::Team> joinTeam();

}  // namespace nao::app
