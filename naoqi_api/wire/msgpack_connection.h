#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/connection.h"
#include "naoqi_api/wire/msgpack_codec.h"
#include "naoqi_api/wire/named_calls.h"

namespace nao::wire {

// MessagePack-RPC:
//   request       [0, id, method, [argument, ...]]
//   response      [1, id, error or nil, result]
//   notification  [2, method, [argument, ...]], either way; never answered
// A method is Service.method, such as "ALMotion.setAngles", or one of the wire's own:
//   authenticate(user, token)      first, where the daemon has --auth
//   services() -> [name]           methods(service) -> [name]
//   subscribe(service.signal) -> link; each emission is a notification service.signal(arguments)
//   unsubscribe(link)
//   property(service.name) -> value          setProperty(service.name, value)
//   release(object)                an object is a text such as "#3": call "#3.method"

/// One client of the msgpack-RPC port.
class MsgpackConnection : public Connection {
 public:
  MsgpackConnection(rpc::ServiceHub& hub, const std::string& endpoint, Send send);
  ~MsgpackConnection() override;

  void receive(const std::uint8_t* bytes, std::size_t count) override;
  void hold() override { held_ = true; }
  void resume() override;
  bool isHeld() const override { return held_; }
  bool wantsClose() const override { return wants_close_; }
  void onBroken(std::function<void()> broken) override { broken_ = std::move(broken); }
  std::size_t bytesHeld() const override { return reader_.bytesHeld(); }
  std::uint64_t messagesTaken() const override { return messages_taken_; }
  bool isOpen() const override { return is_open_; }

 private:
  using Result = rpc::Pending<Value>;
  using Arguments = std::vector<Value>;

  void takeAll();
  bool take(const Value& message);
  void request(const Value& id, const std::string& method, const Arguments& arguments);
  Result run(const std::string& method, const Arguments& arguments);
  Result runOwn(const std::string& method, const Arguments& arguments);
  Result authenticate(const Arguments& arguments);
  Result methods(const std::string& target);
  Result subscribe(const std::string& member);
  void notify(const std::string& signal, const Arguments& arguments);
  void answer(const Value& id, const rpc::Outcome<Value>& outcome);
  void sendNow(const Value& message);

  rpc::ServiceHub& hub_;
  Send send_;
  std::function<void()> broken_;
  NamedCalls calls_;
  NameOf name_of_;
  MsgpackReader reader_;
  std::uint64_t messages_taken_ = 0;
  bool is_open_ = false;
  bool may_call_;
  bool held_ = false;
  bool wants_close_ = false;
  int failures_ = 0;                                        // to authenticate
  std::deque<std::pair<Value, rpc::Outcome<Value>>> late_;  // ended, not answered yet
  std::shared_ptr<MsgpackConnection*> alive_;
};

}  // namespace nao::wire
