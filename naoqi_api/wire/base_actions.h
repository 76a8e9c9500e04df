#pragma once

#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/wire/object_host.h"
#include "naoqi_api/wire/subscriptions.h"

namespace nao::wire {

/// What the actions that every object has act upon.
struct BaseContext {
  Address address;  // of the call
  rpc::Service& service;
  ObjectHost& objects;
  Subscriptions& subscriptions;
  bool documents_members;
};

/// Runs one of the actions below 100 (see wire/metaobject.h), which must exist, with arguments
/// of its declared types. @throws rpc::CallError
rpc::Pending<Value> runBaseAction(const BaseContext& context, const std::vector<Value>& arguments);

}  // namespace nao::wire
