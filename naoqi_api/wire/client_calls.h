#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "naoqi_api/pending.h"
#include "naoqi_api/signal.h"
#include "naoqi_api/tasks.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/codec.h"

namespace nao::wire {

/// The calls this end makes to what the client hosts, until they are answered, and the signals it
/// listens to there. When the client goes all calls fail and nothing comes any more.
class ClientCalls : public std::enable_shared_from_this<ClientCalls> {
 public:
  static constexpr std::size_t kMost = 1024;  // calls not answered yet
  /// How long a client has to answer that it will tell of a signal, in simulated time.
  static constexpr Duration kMostListenWait = std::chrono::seconds(5);

  /// Without `alarm` that time has no end.
  ClientCalls(std::shared_ptr<Channel> channel, rpc::Alarm alarm)
      : channel_(std::move(channel)), alarm_(std::move(alarm)) {}

  /// How objects among arguments and results travel; null once the client has gone.
  void setObjects(ObjectCodec* objects) { objects_ = objects; }

  /// Calls with a tuple that fits `parameters`; the result is read as `returns`. Canceling the
  /// result cancels the call there.
  rpc::Pending<Value> call(const Address& address, const Value& arguments,
                           const Signature& parameters, const std::string& returns);

  /// Sends a call that wants no answer.
  void post(const Address& address, Bytes arguments);

  /// Asks for the events of the signal at `signal`, which `emitter` then emits. Ends when the
  /// client has answered, or has had its time; fails with the client's error.
  rpc::Pending<void> listen(const Address& signal, const rpc::Emitter& emitter);
  void stopListening(const Address& signal);

  /// Takes a Reply, Error or Canceled that came. Unknown numbers are ignored.
  void take(const Message& answer);

  /// Takes an Event that came. One that nobody asked for, or that is not what the signal declares,
  /// is ignored.
  void takeEvent(const Message& event);

  /// The client has gone.
  void failAll();

  bool isOpen() const { return channel_->isOpen(); }

 private:
  struct Open {
    Address address;
    rpc::Pending<Value> result;
    std::string returns;
  };
  using Place = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
  struct Heard {
    std::uint64_t link = 0;
    rpc::Emitter emitter;
  };

  void endInTime(const rpc::Pending<void>& listening) const;
  Value result(const Open& open, const Message& answer);
  void cancel(std::uint32_t id);

  std::shared_ptr<Channel> channel_;
  rpc::Alarm alarm_;
  ObjectCodec* objects_ = nullptr;
  std::map<std::uint32_t, Open> open_;
  std::map<Place, Heard> heard_;
  std::uint64_t next_link_ = 1;
};

}  // namespace nao::wire
