#pragma once

#include <memory>
#include <string>

#include "naoqi_api/al_module.h"

namespace nao::services {

using ServicePointer = std::shared_ptr<rpc::Service>;

/// A service with the methods that all modules have.
inline ServicePointer makeModule(const std::string& name, const std::string& meaning) {
  return std::make_shared<rpc::Service>(rpc::alModule(name, meaning));
}

}  // namespace nao::services
