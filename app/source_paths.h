#pragma once

#include <string>
#include <vector>

namespace nao::app {

/// `path` as given if it exists or is absolute, else below the source tree the program was built
/// from, so that the shipped robots and worlds are found from any folder.
std::string findSourceFile(const std::string& path);

/// The program that writes films, beside this one.
std::string findEncoder();

/// The folders of motions shipped for every robot.
std::vector<std::string> shippedMotions();

/// The motion file called `name`: that path, or the motion of that name (without its ending) that
/// is shipped with this robot or for all. @throws InputError that lists the shipped ones.
std::string findMotionFile(const std::string& name, const std::string& robot);

}  // namespace nao::app
