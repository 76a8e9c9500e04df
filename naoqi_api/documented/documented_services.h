#pragma once

#include <string>
#include <vector>

#include "naoqi_api/service_hub.h"

namespace nao::services {

/// A method as NaoQi's documentation or published interfaces name it.
struct DocumentedMethod {
  std::string name;
  std::string parameters;  // "(sf)"; "(?)": how many and which is not published
  std::string returns;
};

struct DocumentedService {
  std::string name;
  std::vector<DocumentedMethod> methods;  // without those every module has
};

/// Every service and method that any NAOqi from 1.12 to 2.8 is known to have.
std::vector<DocumentedService> documentedServices();

/// The one of that name; without methods if there is none.
DocumentedService documentedService(const std::string& name);

/// Completes a hub: services that it does not have, and methods that its services do not have, are
/// there afterwards and answer that they are not simulated.
void addDocumented(rpc::ServiceHub& hub);

/// What a method answers that is not simulated.
std::string notSimulated(const std::string& service, const std::string& method);

}  // namespace nao::services
