#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "naoqi_api/pending.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/codec.h"

namespace nao::wire {

/// The calls this end makes to what the client hosts, until they are answered. When the client
/// goes they all fail.
class ClientCalls {
 public:
  static constexpr std::size_t kMost = 1024;

  explicit ClientCalls(std::shared_ptr<Channel> channel) : channel_(std::move(channel)) {}

  /// How objects among arguments and results travel; null once the client has gone.
  void setObjects(ObjectCodec* objects) { objects_ = objects; }

  /// Calls with a tuple that fits `parameters`; the result is read as `returns`.
  rpc::Pending<Value> call(const Address& address, const Value& arguments,
                           const Signature& parameters, const std::string& returns);

  /// Sends a call that wants no answer.
  void post(const Address& address, Bytes arguments);

  /// Takes a Reply, Error or Canceled that came. Unknown numbers are ignored.
  void take(const Message& answer);

  /// The client has gone.
  void failAll();

  bool isOpen() const { return channel_->isOpen(); }

 private:
  struct Open {
    rpc::Pending<Value> result;
    std::string returns;
  };

  Value result(const Open& open, const Message& answer);

  std::shared_ptr<Channel> channel_;
  ObjectCodec* objects_ = nullptr;
  std::map<std::uint32_t, Open> open_;
};

}  // namespace nao::wire
