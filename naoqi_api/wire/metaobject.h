#pragma once

#include <cstdint>

#include "naoqi_api/service.h"
#include "naoqi_api/value.h"

namespace nao::wire {

using rpc::Signature;

// The actions every object has, below rpc::Service::kFirstUid.
namespace base_action {
constexpr std::uint32_t kRegisterEvent = 0;
constexpr std::uint32_t kUnregisterEvent = 1;
constexpr std::uint32_t kMetaObject = 2;
constexpr std::uint32_t kTerminate = 3;
constexpr std::uint32_t kProperty = 5;
constexpr std::uint32_t kSetProperty = 6;
constexpr std::uint32_t kProperties = 7;
constexpr std::uint32_t kRegisterEventWithSignature = 8;
constexpr std::uint32_t kIsStatsEnabled = 80;
constexpr std::uint32_t kEnableStats = 81;
constexpr std::uint32_t kStats = 82;
constexpr std::uint32_t kClearStats = 83;
constexpr std::uint32_t kIsTraceEnabled = 84;
constexpr std::uint32_t kEnableTrace = 85;
constexpr std::uint32_t kTraceObject = 86;  // a signal
}  // namespace base_action

/// The signature of a metaobject.
const char* metaObjectSignature();

/// Name and types of one of the actions above; null for an id that is none.
struct BaseMethod {
  std::uint32_t uid;
  const char* name;
  const char* parameters;
  const char* returns;
};
const BaseMethod* findBaseMethod(std::uint32_t uid);

/// The same as types. They stay.
struct BaseTypes {
  Signature parameters;
  Signature returns;
};
const BaseTypes& typesOf(const BaseMethod& method);

/// What `service` offers, as clients ask for it; `with_texts` says whether the meanings go along.
rpc::Value metaObjectOf(const rpc::Service& service, bool with_texts);

}  // namespace nao::wire
