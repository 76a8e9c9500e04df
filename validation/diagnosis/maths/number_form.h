#pragma once

namespace nao::validation {

/// How a number of a cause becomes an effect's parameter.
enum class Form {
  Offset,   // parameter = neutral + number
  Inverse,  // parameter = 1 / number, for limits that are infinite when they do nothing
};

}  // namespace nao::validation
