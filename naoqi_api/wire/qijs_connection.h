#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/json_codec.h"
#include "naoqi_api/wire/named_calls.h"

namespace nao::wire {

// qi.js speaks JSON in the messages of socket.io 0.9, type:id:endpoint:data :
//   1::  connected    2::  heartbeat, answered with the same    0::  good bye    5:::{...}  event
// Events of the client:
//   {"name":"call","args":[{"idm":N,"params":{"obj":O,"member":M,"args":[...]}}]}
// where O is "ServiceDirectory" or the number of an object (1.0 says "method" for "member"), and
// for a signal or property M the args are ["connect"], ["disconnect", link], ["value"],
// ["setValue", v]. Events of ours, with N and a result: "reply", "error" (its text), and "signal":
//   {"result":{"obj":O,"signal":M,"data":[...],"link":L}}

/// One page of the qi.js wire, without its WebSocket: texts in, texts out. I/O thread.
class QijsConnection {
 public:
  static constexpr std::size_t kMaxText = 1U << 20U;  // letters of one message

  using Send = std::function<void(std::string text)>;

  /// Says at once that it is connected. `broken`: an event can not be sent, close.
  QijsConnection(rpc::ServiceHub& hub, const std::string& endpoint, Send send,
                 std::function<void()> broken);
  QijsConnection(const QijsConnection&) = delete;
  QijsConnection& operator=(const QijsConnection&) = delete;
  ~QijsConnection();

  /// One message. False if the page said good bye, or what came is no message: close.
  bool receive(std::string_view text);

 private:
  using Result = rpc::Pending<Value>;
  /// What a page asks for.
  struct Call {
    Value number;  // idm
    std::string object;
    std::string member;
    std::vector<Value> arguments;
  };

  bool takeEvent(std::string_view json);
  void run(const Call& call);
  Result runMember(const Call& call, const std::string& target);
  Result runSignal(const Call& call, const std::string& target, bool is_property);
  Result findService(const Call& call);
  Result listen(const Call& call, const std::string& target, const std::string& signal);
  void answer(const Value& number, const rpc::Outcome<Value>& outcome);
  void sendEvent(const char* name, const std::string& json);
  std::string jsonOf(const ObjectRef& object);

  Send send_;
  std::function<void()> broken_;
  NamedCalls calls_;
  NameOf json_of_;
  std::shared_ptr<QijsConnection*> alive_;
};

}  // namespace nao::wire
