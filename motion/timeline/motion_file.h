#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a motion from a file of any kind known here, chosen by its extension, or by how it begins
/// where the extension says nothing: .xar, .crg, .qianim, Webots .motion, .kme (Kouretes), .pos
/// (rUNSWift), .mof (B-Human), .kfm (Nao Devils), .json (HULKs), .route (our own), .pml
/// (a package with one behavior), or a behavior's folder. What could not be played of it
/// stands in the timeline's warnings.
/// @throws InputError with file and line if it can not be read, is of an unknown kind, or holds no
/// joint angles (.kmc, .pmt).
Timeline loadMotion(const std::filesystem::path& file, const RobotModel& model);

/// Whether a file has the ending of a motion that loadMotion() may play. The file is not opened.
bool isMotionFile(const std::filesystem::path& file);

/// The .xar of a behavior (a folder, a package, the file itself) if a box of it has code; nothing
/// for other kinds of motions, packed ones too.
/// @throws InputError if it can not be read or is no behavior.
std::optional<std::filesystem::path> findCode(const std::filesystem::path& file);

/// The timeline of one box of a behavior (.xar, .crg, .pml, folder), as if it were started alone.
/// @throws InputError as loadMotion(), or with the boxes there are if none is called `box`.
Timeline loadBox(const std::filesystem::path& file, const std::string& box,
                 const RobotModel& model);

/// The same of a text; `source` is its name in messages and has the extension.
Timeline readMotion(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
