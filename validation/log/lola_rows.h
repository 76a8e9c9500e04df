#pragma once

#include <string>

#include "validation/log/robot_log.h"

namespace nao::validation {

/// The rows of LoLA frames one after the other; of the run only t and columns are filled in.
/// @throws InputError with the byte at which no frame begins.
LogRun readLolaRows(const std::string& bytes, const std::string& file);

}  // namespace nao::validation
