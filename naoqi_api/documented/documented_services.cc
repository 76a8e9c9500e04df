#include "naoqi_api/documented/documented_services.h"

#include <array>
#include <memory>
#include <sstream>
#include <utility>

#include "core/check.h"
#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/signature.h"

namespace nao::services {
namespace {

constexpr std::array<const char*, 6> kTables = {
#include "naoqi_api/documented/audio.inc"
    ,
#include "naoqi_api/documented/core.inc"
    ,
#include "naoqi_api/documented/motion.inc"
    ,
#include "naoqi_api/documented/people.inc"
    ,
#include "naoqi_api/documented/sensing.inc"
    ,
#include "naoqi_api/documented/vision.inc"
};

// What NaoQi's extractors have in common.
constexpr char kExtractor[] =
    "subscribe(s)v subscribe(sif)v unsubscribe(s)v updatePeriod(si)v updatePrecision(sf)v "
    "getCurrentPeriod()i getCurrentPrecision()f getMyPeriod(s)i getMyPrecision(s)f "
    "getSubscribersInfo()m getOutputNames()[s] getEventList()[s] getMemoryKeyList()[s]";

// "fade(sff)v"
DocumentedMethod readMethod(const std::string& text) {
  const std::size_t open = text.find('(');
  NAO_CHECK(open != std::string::npos);
  std::size_t end = open;
  for (int depth = 0; end < text.size(); ++end) {
    if (text[end] == '(') ++depth;
    if (text[end] == ')' && --depth == 0) break;
  }
  return {text.substr(0, open), text.substr(open, end + 1 - open), text.substr(end + 1)};
}

void readMethods(const std::string& line, DocumentedService& service) {
  std::istringstream words(line);
  for (std::string word; words >> word;) service.methods.push_back(readMethod(word));
}

std::size_t countArguments(const std::string& parameters) {
  return rpc::Signature::of(parameters).children().size();
}

constexpr char kUnknown[] = "(?)";

// Of a method whose parameters are not known any form will do.
bool has(const rpc::Service& service, const DocumentedMethod& wanted) {
  for (const auto& [uid, method] : service.methods()) {
    if (method.name != wanted.name) continue;
    if (wanted.parameters == kUnknown ||
        countArguments(method.parameters_signature) == countArguments(wanted.parameters)) {
      return true;
    }
  }
  return false;
}

rpc::Method refuse(const std::string& service, const DocumentedMethod& documented) {
  rpc::Method method;
  method.name = documented.name;
  method.parameters_signature = documented.parameters;
  method.return_signature = documented.returns;
  method.meaning = "Not simulated.";
  method.arguments.resize(countArguments(documented.parameters));
  for (std::size_t i = 0; i < method.arguments.size(); ++i) {
    method.arguments[i] = {"argument" + std::to_string(i + 1), "Ignored."};
  }
  method.answer = rpc::Answer::NotSimulated;
  const std::string text = notSimulated(service, documented.name);
  method.call = [text](const rpc::Caller&, const std::vector<rpc::Value>&) {
    rpc::Pending<rpc::Value> failed;
    failed.fail(text);
    return failed;
  };
  return method;
}

void addMissing(const DocumentedService& documented, rpc::Service& service) {
  for (const DocumentedMethod& method : documented.methods) {
    if (has(service, method)) continue;
    if (method.parameters != kUnknown) {
      service.add(refuse(documented.name, method));
      continue;
    }
    for (const char* form : {"()", "(m)", "(mm)", "(mmm)"}) {
      service.add(refuse(documented.name, {method.name, form, method.returns}));
    }
  }
}

}  // namespace

std::vector<DocumentedService> documentedServices() {
  std::vector<DocumentedService> services;
  for (const char* table : kTables) {
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
      if (line.empty()) continue;
      if (line[0] == ' ') {
        readMethods(line, services.back());
        continue;
      }
      std::istringstream words(line);
      std::string name;
      std::string kind;
      words >> name >> kind;
      services.push_back({name, {}});
      if (kind == "extractor") readMethods(kExtractor, services.back());
    }
  }
  return services;
}

DocumentedService documentedService(const std::string& name) {
  for (DocumentedService& service : documentedServices()) {
    if (service.name == name) return std::move(service);
  }
  return {name, {}};
}

void addDocumented(rpc::ServiceHub& hub) {
  for (const DocumentedService& documented : documentedServices()) {
    if (const auto service = hub.findService(documented.name)) {
      addMissing(documented, *service);
      continue;
    }
    rpc::Service service = rpc::alModule(documented.name, "Not simulated.");
    addMissing(documented, service);
    hub.add(std::move(service));
  }
}

std::string notSimulated(const std::string& service, const std::string& method) {
  return naoqiError(service + "::" + method,
                    "not simulated: docs/services.md and `usarnaoqi describe --services` list "
                    "what is");
}

}  // namespace nao::services
