#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "naoqi_api/convert.h"

namespace nao::services {

/// How to reach a service, as ServiceDirectory tells it.
struct ServiceInfo {
  std::string name;
  std::uint32_t service_id = 0;
  std::string machine_id;
  std::uint32_t process_id = 0;
  std::vector<std::string> endpoints;
  std::string session_id;
  std::string object_uid;  // 20 raw bytes, or empty
};

/// Up to NAOqi 2.8 a ServiceInfo has no object uid.
enum class ServiceInfoFields { Six, Seven };

std::string serviceInfoSignature(ServiceInfoFields fields);
rpc::Value toValue(const ServiceInfo& info, ServiceInfoFields fields);

/// Reads either form. @throws rpc::CallError
ServiceInfo serviceInfoOf(const rpc::Value& value);

}  // namespace nao::services
