#pragma once

#include <string>
#include <vector>

#include "validation/log/robot_log.h"

namespace nao::hidden {

/// The angle of one joint [rad], one list per repeat: its motions one after another. Every motion
/// must have the same number of repeats.
using Repeats = std::vector<std::vector<double>>;
Repeats repeatsOf(const validation::LogSet& set, const std::string& joint);
/// The same of any column, in its unit.
Repeats repeatsOfColumn(const validation::LogSet& set, const std::string& name);

/// Repeat by repeat and sample by sample: a - factor * b. Repeats that were made by the same chance
/// differ by what an effect does, and by little else.
Repeats less(const Repeats& a, const Repeats& b, double factor = 1);

/// The SD of the repeats about their mean [rad].
double spreadOf(const Repeats& repeats);

/// The RMS of the mean over the samples where it is at least a twentieth of its most. What the
/// repeats' own differences leave in such a mean by chance (an encoder's counts) is taken off.
double rmsWhereActing(const Repeats& change);

/// The sum of the means' products over all samples.
double productOf(const Repeats& a, const Repeats& b);

}  // namespace nao::hidden
