#pragma once

#include <optional>
#include <vector>

#include "naoqi_api/signature.h"
#include "naoqi_api/value.h"
#include "naoqi_api/wire/codec.h"

namespace nao::wire {

// How a signal's arguments travel is what it declares:
//   (T...)  the arguments, one after the other
//   [T]     the list of them
//   m       a dynamic that holds the tuple of them, each with the type it has

/// Whether a signal may declare `type`.
bool carriesArguments(const rpc::Signature& type);

/// Appends what an event with these arguments consists of. False, and nothing appended, if they are
/// not what is declared. @throws CodecError
bool encodeEvent(rpc::Bytes& out, const std::vector<rpc::Value>& arguments,
                 const rpc::Signature& declared, ObjectCodec* objects);

/// The arguments of an event, be it of type `declared` or dynamic; nothing if they do not fit.
/// What came as `m` and is no tuple is the one argument.
std::optional<std::vector<rpc::Value>> argumentsOf(rpc::Value event,
                                                   const rpc::Signature& declared);

}  // namespace nao::wire
