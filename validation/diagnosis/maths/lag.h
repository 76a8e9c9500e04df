#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// The value at a row, linear between rows; the first or last beyond them.
double atRow(const Eigen::VectorXd& rows, double place);

/// As it was told, as many rows earlier as it came late.
Eigen::VectorXd earlier(const Eigen::VectorXd& rows, double late);

/// By how many rows `told` comes after `course`, to a tenth of one: 0 to 10. 0 of what rests.
double rowsLate(const Eigen::VectorXd& told, const Eigen::VectorXd& course);

}  // namespace nao::validation
