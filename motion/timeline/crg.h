#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a packed behavior (.crg): a Unix `ar` whose data.tar.gz (or data.tar) holds behavior.xar,
/// which is read as by readXar.
/// @throws InputError that names the file, and the line of the behavior where it has one.
Timeline readCrg(const std::string& bytes, const std::string& source, const RobotModel& model);

/// The text of the behavior.xar packed there. @throws InputError that names the file.
std::string unpackCrg(const std::string& bytes, const std::string& source);

}  // namespace nao::motion
