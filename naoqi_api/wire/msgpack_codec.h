#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "naoqi_api/value.h"

namespace nao::wire {

// MessagePack and NaoQi's values:
//   nil            void            bool       b         int   i, or l or L if it does not fit
//   float32, 64    f, d            str        s         bin   r
//   array          [m]             map        {mm}      ext   refused
// and back, where a tuple is an array, an optional is its value or nil, and an object is the text
// that `nameOf` gives it.

/// Names an object that is passed to the client.
using NameOf = std::function<std::string(const rpc::ObjectRef&)>;

/// Appends `value`. @throws rpc::CallError if `name_of` does
void packValue(rpc::Bytes& out, const rpc::Value& value, const NameOf& name_of);

/// Cuts a stream of bytes into MessagePack values. Half a value in, nothing out.
class MsgpackReader {
 public:
  static constexpr std::size_t kMaxBytes = 16U << 20U;  // of one value

  MsgpackReader();
  ~MsgpackReader();

  /// The most bytes that one value may have.
  void setMaxBytes(std::size_t most);

  void push(const std::uint8_t* bytes, std::size_t count);
  std::optional<rpc::Value> next();

  /// True once something came that is no MessagePack, too large or nested too deep.
  bool isBroken() const;

  /// What the beginning of a value that waits for its rest takes here.
  std::size_t bytesHeld() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::wire
