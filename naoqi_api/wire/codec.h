#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "naoqi_api/signature.h"
#include "naoqi_api/value.h"
#include "naoqi_api/wire/frame.h"

namespace nao::wire {

using rpc::ObjectRef;
using rpc::Signature;
using rpc::Value;

/// Bytes that are not what their signature says. Becomes an error reply.
struct CodecError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Decoder;

/// How objects travel: that depends on what the two ends agreed on and on who hosts what.
class ObjectCodec {
 public:
  virtual ~ObjectCodec() = default;
  virtual void encode(Bytes& out, const ObjectRef& object) = 0;
  virtual ObjectRef decode(Decoder& decoder) = 0;
};

/// What one message may at most unfold into: a few bytes must not become gigabytes.
struct DecodeBudget {
  std::size_t values = 1U << 20U;             // all of them
  std::size_t empty_values = 65536;           // those that take no bytes
  std::size_t signature_letters = 1U << 20U;  // of all dynamics
  std::size_t type_letters = 64U << 20U;      // that lists, maps and tuples keep of their type
};

/// Reads values from the bytes of one message, front to back. Everything it reads is checked
/// against the bytes that are left. @throws CodecError
class Decoder {
 public:
  /// Without `objects` an object in the bytes is an error.
  explicit Decoder(const Bytes& bytes, ObjectCodec* objects = nullptr)
      : bytes_(bytes), objects_(objects) {}

  Value read(const Signature& signature);
  Value read(std::string_view signature) { return read(Signature::of(signature)); }

  template <class T>
  T number();
  std::string text();
  Bytes raw(std::size_t count);

  std::size_t left() const { return bytes_.size() - at_; }

 private:
  Value readAt(const Signature& signature, int depth);
  Value readKind(const Signature& signature, int depth);
  Value readDynamic(int depth);
  Value readList(const Signature& element, int depth);
  Value readMap(const Signature& signature, int depth);
  Value readTuple(const Signature& signature, int depth);
  Value readOptional(const Signature& element, int depth);
  std::size_t count(const Signature& element);
  const std::uint8_t* take(std::size_t count);
  std::string typeText(const Signature& signature);
  static void spend(std::size_t& budget, std::size_t amount = 1);

  const Bytes& bytes_;
  ObjectCodec* objects_;
  std::size_t at_ = 0;
  DecodeBudget budget_;
};

/// Appends `value`, which must be of exactly that signature (see rpc::convert).
void encode(Bytes& out, const Value& value, const Signature& signature,
            ObjectCodec* objects = nullptr);

/// Appends `value` as a dynamic: its own signature, then itself. @throws CodecError if it is nested
/// too deep to be named.
void encodeDynamic(Bytes& out, const Value& value, ObjectCodec* objects = nullptr);

}  // namespace nao::wire
