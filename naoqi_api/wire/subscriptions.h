#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "naoqi_api/signal.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/codec.h"
#include "naoqi_api/wire/object_host.h"

namespace nao::wire {

/// The signals that one client listens to. Every emission becomes an Event, in order.
class Subscriptions {
 public:
  static constexpr std::size_t kMost = 4096;

  Subscriptions(std::shared_ptr<Channel> channel, ObjectHost& objects)
      : channel_(std::move(channel)), objects_(objects) {}
  Subscriptions(const Subscriptions&) = delete;
  Subscriptions& operator=(const Subscriptions&) = delete;
  ~Subscriptions() { clear(); }

  /// `signal` is where it comes from, `link` the client's own number for it, `wished` the signature
  /// it wants, or empty. Returns our number. @throws rpc::CallError if there are too many.
  std::uint64_t add(const Address& signal, std::uint64_t link, const rpc::Emitter& emitter,
                    std::string wished);

  /// False if there is no such subscription.
  bool remove(const Address& signal, std::uint64_t link);

  /// Ends the subscription of that number of ours, if there still is one. It may be called later
  /// than this lives.
  std::function<void()> dropper(std::uint64_t number);

  /// Forgets all subscriptions to one object.
  void removeObject(std::uint32_t service, std::uint32_t object);
  void clear();

 private:
  struct Subscription {
    Address signal;
    std::uint64_t link = 0;
    rpc::Emitter emitter;
    std::uint64_t emitter_link = 0;
    std::string wished;
    Signature declared;  // of the emitter
  };
  using All = std::map<std::uint64_t, Subscription>;

  void send(const Subscription& known, const rpc::Emission& emission);
  void write(Message& event, const Subscription& known, const std::vector<Value>& arguments);
  bool sendShared(const Message& event, const Subscription& known, const rpc::Emission& emission);
  All::iterator drop(All::iterator subscription);

  std::shared_ptr<Channel> channel_;
  ObjectHost& objects_;
  All all_;
  std::uint64_t next_ = 1;
  std::shared_ptr<Subscriptions*> alive_ = std::make_shared<Subscriptions*>(this);
};

}  // namespace nao::wire
