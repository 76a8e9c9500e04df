#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/wire/client_object.h"

namespace nao::wire {

/// The fields of each entry of a metaobject's map number `which`: 0 methods, 1 signals,
/// 2 properties; by uid. Entries that are not what they should be are left out.
std::map<std::uint32_t, std::vector<Value>> metaObjectEntries(const Value& metaobject,
                                                              std::size_t which);

/// What a client's object offers as a service of ours: other clients, and other wires, call it as
/// they call any. Members whose signatures mean nothing are left out. Keeps `object` alive.
std::shared_ptr<rpc::Service> offerOf(const Value& metaobject,
                                      const std::shared_ptr<ClientObject>& object);

}  // namespace nao::wire
