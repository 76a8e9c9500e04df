#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "core/check.h"
#include "validation/diagnosis/jobs/packed.h"

// How values are packed: for the sources that make packed types of their own.

namespace Eigen {

inline void to_json(nlohmann::json& json, const VectorXd& values) {
  json = std::vector<double>(values.data(), values.data() + values.size());
}

inline void from_json(const nlohmann::json& json, VectorXd& values) {
  const auto list = json.get<std::vector<double>>();
  values = Map<const VectorXd>(list.data(), static_cast<Index>(list.size()));
}

}  // namespace Eigen

namespace nao::validation {

// CBOR: unlike text it holds every double, infinite ones too.
template <class T>
std::string pack(const T& value) {
  std::string bytes;
  nlohmann::json::to_cbor(nlohmann::json(value), bytes);
  return bytes;
}

template <class T>
T unpack(const std::string& bytes) {
  try {
    return nlohmann::json::from_cbor(bytes).get<T>();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("a kept part of a diagnosis can not be read: ") + error.what());
  }
}

/// Makes `Type`, which JSON must know, a packed type.
#define NAO_PACKED(Type)                  \
  template std::string pack(const Type&); \
  template Type unpack(const std::string&);

}  // namespace nao::validation
