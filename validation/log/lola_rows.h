#pragma once

#include <string>
#include <vector>

#include "validation/log/robot_log.h"

namespace nao::validation {

/// The rows of LoLA frames one after the other; of the run only t and columns are filled in.
/// @throws InputError with the byte at which no frame begins.
LogRun readLolaRows(const std::string& bytes, const std::string& file);

/// The names of the 25 joints in the order of all its arrays, hands last.
const std::vector<std::string>& lolaJoints();

/// The joints' angles [rad], hands 0..1, in a sensor frame. @throws InputError if it has none.
std::vector<double> readLolaAngles(const std::string& frame);

/// The actuator frame that asks for these; one value per joint in each list.
std::string encodeLolaCommand(const std::vector<double>& angles,
                              const std::vector<double>& stiffness);

}  // namespace nao::validation
