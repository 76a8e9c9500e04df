#pragma once

#include <string>

#include "naoqi_api/service_hub.h"

// The API reference, made from the declarations of the services themselves.
namespace nao::rpc {

/// Name and meaning of every member of a service, for a terminal.
std::string referenceText(const Service& service);

/// The same as Markdown.
std::string referenceMarkdown(const Service& service);

/// The page docs/services.md: how much of each service is simulated.
std::string coveragePage(const ServiceHub& hub);

/// All of it as one JSON object: {"services": [{"name", "meaning", "methods": [{"name", "uid",
/// "parameters", "returns", "meaning", "answer"}], "signals", "properties"}]}.
std::string referenceJson(const ServiceHub& hub, const std::string& only = {});

}  // namespace nao::rpc
