#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/client_calls.h"
#include "naoqi_api/wire/object_host.h"
#include "naoqi_api/wire/subscriptions.h"

namespace nao::wire {

/// Carries out what one client asks once its connection is open: calls, posts, cancels, and the
/// answers to calls that were made to it.
class Dispatcher : public std::enable_shared_from_this<Dispatcher> {
 public:
  static constexpr std::size_t kMostUnfinished = 1024;
  static constexpr std::size_t kMostWaiting = 64;  // for what another client's service offers

  Dispatcher(rpc::ServiceHub& hub, std::shared_ptr<Channel> channel,
             std::shared_ptr<rpc::Session> session);

  /// Takes a message that is not about the opening.
  void dispatch(const Message& message);

  /// Keeps the answers to calls that end later back until resume(), in order, as values: the client
  /// does not read as fast as they come.
  void hold() { held_ = true; }
  void resume();

  /// The client has gone: results that come later go nowhere.
  void end();

 private:
  struct Request {
    std::vector<Value> arguments;
    std::string wished;  // the signature the client wants back, or empty
  };
  /// A call under way: all that is needed to answer it.
  struct Call {
    Message header;  // without payload
    std::shared_ptr<rpc::Service> service;
    const Signature* returns = nullptr;  // of the service's method, or of a base action
    std::string wished;
    std::uint32_t trace = 0;   // its number among traced calls; 0: it is not traced
    std::uint32_t action = 0;  // that is traced
  };

  void call(const Message& message);
  bool isHostedByClient(const Address& address) const;
  void callLater(const Message& message);
  void callBase(const Message& message, const std::shared_ptr<rpc::Service>& service);
  void callMethod(const Message& message, const std::shared_ptr<rpc::Service>& service);
  void emit(const Message& message, const rpc::Emitter& emitter);
  void cancel(const Message& message);

  Request readRequest(const Message& message, const Signature& parameters);
  rpc::Pending<Value> run(Call& call, const rpc::Method& method,
                          const std::vector<Value>& arguments);
  void await(const Call& call, const rpc::Pending<Value>& result);
  void finish(const Call& call, const rpc::Outcome<Value>& outcome);
  void finishLate(const Call& call, const rpc::Outcome<Value>& outcome);
  void trace(const Call& call, rpc::Monitor::Event event, const Value& content) const;
  void answer(const Call& call, const rpc::Outcome<Value>& outcome);
  void answer(const Call& call, const Value& result);
  void answerCanceled(const Call& call);

  rpc::ServiceHub& hub_;
  std::shared_ptr<Channel> channel_;
  std::shared_ptr<rpc::Session> session_;
  std::shared_ptr<ClientCalls> client_calls_;
  ObjectHost objects_;
  Subscriptions subscriptions_;
  struct Unfinished {
    std::uint32_t id = 0;  // the client's number
    rpc::Pending<Value> result;
  };
  std::map<std::uint64_t, Unfinished> unfinished_;  // by our own number
  std::uint64_t next_unfinished_ = 1;
  std::size_t waiting_ = 0;
  bool held_ = false;
  std::deque<std::pair<Call, rpc::Outcome<Value>>> late_;  // ended, not answered yet
};

}  // namespace nao::wire
