#include "naoqi_api/wire/qi_connection.h"

#include <utility>

#include "naoqi_api/wire/codec.h"
#include "naoqi_api/wire/dispatcher.h"

namespace nao::wire {
namespace {

constexpr std::uint32_t kAuthenticate = 8;   // an action of service 0, object 0
constexpr std::uint32_t kAuthenticated = 3;  // 1 error, 2 continue, 3 done
constexpr char kAuthState[] = "__qi_auth_state";
constexpr char kCapabilityMap[] = "{sm}";

/// What a client says when it comes.
struct Opening {
  Capabilities capabilities;
  std::string user;
  std::string token;
};

Opening readOpening(const Bytes& payload) {
  const Value map = Decoder(payload).read(kCapabilityMap);
  Opening opening;
  for (const auto& [key, value] : map.find<Value::Map>()->entries) {
    const std::string& name = *key.findText();
    const bool* on = value.find<bool>();
    opening.capabilities[name] = on && *on;
    const std::string* text = value.findText();
    if (text && name == "auth_user") opening.user = *text;
    if (text && name == "auth_token") opening.token = *text;
  }
  return opening;
}

Value::Map toMap(const Capabilities& capabilities) {
  Value::Map map{"s", "m", {}};
  for (const auto& [name, on] : capabilities) map.entries.emplace_back(name, on);
  return map;
}

Bytes encodeMap(const Value::Map& map) {
  Bytes payload;
  encode(payload, map, Signature::of(kCapabilityMap));
  return payload;
}

}  // namespace

QiConnection::QiConnection(rpc::ServiceHub& hub, std::string endpoint, Channel::Send send)
    : hub_(hub),
      channel_(std::make_shared<Channel>(std::move(send), hub.options().personality.capabilities)),
      session_(std::make_shared<rpc::Session>(hub.takeSessionId(), std::move(endpoint))),
      dispatcher_(std::make_shared<Dispatcher>(hub_, channel_, session_)) {}

QiConnection::~QiConnection() {
  channel_->close();
  dispatcher_->end();
  session_->end();
}

void QiConnection::receive(const std::uint8_t* bytes, std::size_t count) {
  if (wants_close_) return;
  reader_.push(bytes, count);
  takeAll();
}

void QiConnection::hold() {
  held_ = true;
  dispatcher_->hold();
}

void QiConnection::resume() {
  if (!std::exchange(held_, false) || wants_close_) return;
  dispatcher_->resume();
  takeAll();
}

void QiConnection::takeAll() {
  while (!held_) {
    const auto message = reader_.next();
    if (!message) break;
    ++messages_taken_;
    take(*message);
    if (wants_close_) return;
  }
  wants_close_ = reader_.isBroken();
}

bool QiConnection::isAuthentication(const Message& message) const {
  return message.type == MessageType::Call && message.address.service == 0 &&
         message.address.object == 0 && message.address.action == kAuthenticate;
}

bool QiConnection::needsAuthentication() const {
  return hub_.options().credentials || hub_.options().personality.needs_authentication;
}

void QiConnection::take(const Message& message) {
  if (message.version > 0) {
    return channel_->error(message,
                           "Cannot negotiate QiMessaging connection: remote end doesn't support "
                           "binary protocol v" +
                               std::to_string(message.version));
  }
  if (isAuthentication(message)) return authenticate(message);
  if (message.type == MessageType::Capability) return takeCapabilities(message);
  const bool is_refused = message.address.service == 0 || (!is_open_ && needsAuthentication());
  if (is_refused) {
    if (message.type == MessageType::Call) {
      channel_->error(message, "The call request could not be handled.");
    }
    return;
  }
  if (!is_open_) sendCapabilities();
  dispatcher_->dispatch(message);
}

void QiConnection::authenticate(const Message& message) {
  Value::Map answer{"s", "m", {}};
  try {
    const Opening opening = readOpening(message.payload);
    const auto& credentials = hub_.options().credentials;
    if (!is_open_ && credentials && !credentials->accept(opening.user, opening.token)) {
      return refuse(message);
    }
    if (!is_open_) {
      channel_->setPeer(opening.capabilities);
      answer = toMap(channel_->own());
      open();
    }
  } catch (const CodecError& error) {
    channel_->error(message, error.what());
    wants_close_ = true;
    return;
  }
  answer.entries.emplace_back(kAuthState, kAuthenticated);
  channel_->reply(message, encodeMap(answer));
}

void QiConnection::refuse(const Message& message) {
  channel_->error(message, "Authentication failed: expected a valid auth_user and auth_token.");
  if (++failures_ >= rpc::Credentials::kMostFailures) wants_close_ = true;
}

// A client from before 2014 tells its capabilities instead of authenticating.
void QiConnection::takeCapabilities(const Message& message) {
  if (needsAuthentication() && !is_open_) return;
  try {
    channel_->setPeer(readOpening(message.payload).capabilities);
  } catch (const CodecError&) {
    wants_close_ = true;
    return;
  }
  if (!is_open_) sendCapabilities();
}

void QiConnection::sendCapabilities() {
  Message message;
  message.type = MessageType::Capability;
  message.payload = encodeMap(toMap(channel_->own()));
  channel_->sendNew(std::move(message));
  open();
}

void QiConnection::open() {
  is_open_ = true;
  reader_.setMaxPayload(kMaxPayload);
  session_->setTakesRelativeEndpoints(channel_->shares("RelativeEndpointURI"));
}

}  // namespace nao::wire
