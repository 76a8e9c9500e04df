#pragma once

#include <string>
#include <vector>

#include "validation/log/robot_log.h"

namespace nao::hidden {

/// The mean of the repeats of every motion of one joint, one motion after another [rad].
std::vector<double> meansOf(const validation::LogSet& set, const std::string& joint);

double rmsOf(const std::vector<double>& a, const std::vector<double>& b);

/// Over the samples where the two differ at all: by a twentieth of the most that they do.
double rmsWhereActing(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace nao::hidden
