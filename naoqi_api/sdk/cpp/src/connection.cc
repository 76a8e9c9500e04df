#include "naoqi_api/sdk/cpp/src/connection.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/sdk/cpp/src/workers.h"
#include "naoqi_api/wire/codec.h"

namespace nao::client {
namespace {

using rpc::Value;

constexpr wire::Address kAuthenticate{0, 0, 8};
constexpr char kGone[] = "the robot has closed the connection";

// What the package understands; a capability counts only if both ends have it. Calls from the
// robot come on this socket, not on one of ours.
Value opening(const Endpoint& endpoint) {
  Value::Map map{"s", "m", {}};
  const auto add = [&map](const char* name, const Value& value) {
    map.entries.emplace_back(Value(name), value);
  };
  add("ClientServerSocket", true);
  add("MessageFlags", true);
  add("MetaObjectCache", false);
  add("RemoteCancelableCalls", false);
  if (!endpoint.user.empty() || !endpoint.token.empty()) {
    add("auth_user", endpoint.user);
    add("auth_token", endpoint.token);
  }
  return map;
}

struct Addresses {
  explicit Addresses(const Endpoint& endpoint) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    const std::string port = std::to_string(endpoint.port);
    if (getaddrinfo(endpoint.host.c_str(), port.c_str(), &hints, &first) != 0) first = nullptr;
  }
  ~Addresses() {
    if (first) freeaddrinfo(first);
  }
  Addresses(const Addresses&) = delete;
  Addresses& operator=(const Addresses&) = delete;
  addrinfo* first = nullptr;
};

std::string errorText(const wire::Message& answer) {
  const Value error = wire::Decoder(answer.payload).read("m");
  return error.findText() ? *error.findText() : "the call failed";
}

}  // namespace

Connection::Connection(const Endpoint& endpoint, Incoming incoming)
    : incoming_(std::move(incoming)) {
  connect(endpoint);
  {
    const std::lock_guard lock(mutex_);
    reader_ = std::thread([this] { read(); });
  }
  try {
    authenticate(endpoint);
  } catch (const std::runtime_error&) {
    close();
    throw;
  }
}

Connection::~Connection() {
  close();
  ::close(socket_);
}

void Connection::connect(const Endpoint& endpoint) {
  const Addresses addresses(endpoint);
  for (const addrinfo* one = addresses.first; one != nullptr; one = one->ai_next) {
    socket_ = ::socket(one->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket_ >= 0 && ::connect(socket_, one->ai_addr, one->ai_addrlen) == 0) break;
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }
  if (socket_ < 0) throw std::runtime_error("Cannot connect to " + endpoint.text());
  const int on = 1;
  setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

// Robots older than 2.4 know no authentication and answer with an error, or their capabilities.
void Connection::authenticate(const Endpoint& endpoint) {
  rpc::Bytes payload;
  wire::encode(payload, opening(endpoint), rpc::Signature::of("{sm}"));
  const wire::Message answer = begin(kAuthenticate, std::move(payload)).get();
  const bool known = !endpoint.user.empty() || !endpoint.token.empty();
  if (answer.type == wire::MessageType::Error) {
    const std::string error = errorText(answer);
    const bool refused = error.rfind("Authentication failed", 0) == 0;
    if (known || refused) throw std::runtime_error(error);
    return;
  }
  const Value state = wire::Decoder(answer.payload).read("{sm}");
  constexpr int kRefused = 1;
  std::string reason;
  for (const auto& [key, value] : state.find<Value::Map>()->entries) {
    const auto number = value.findNumber();
    if (*key.findText() == "__qi_auth_state" && number && *number <= kRefused) reason = "refused";
  }
  if (!reason.empty()) throw std::runtime_error(endpoint.text() + " does not let us in");
}

std::future<wire::Message> Connection::begin(const wire::Address& address, rpc::Bytes payload) {
  wire::Message message;
  message.address = address;
  message.payload = std::move(payload);
  std::future<wire::Message> answer;
  {
    const std::lock_guard lock(mutex_);
    if (lost_) throw rpc::CallError(kGone);
    message.id = next_id_++;
    answer = open_calls_[message.id].get_future();
  }
  send(message);
  return answer;
}

Value Connection::call(const wire::Address& address, const Value& arguments,
                       const std::string& returns) {
  rpc::Bytes payload;
  wire::encode(payload, arguments, rpc::Signature::of(arguments.signature()));
  std::future<wire::Message> future = begin(address, std::move(payload));
  wire::Message answer;
  {
    const Workers::Waiting waiting;
    answer = future.get();
  }
  if (answer.type == wire::MessageType::Error) throw rpc::CallError(errorText(answer));
  if (answer.type == wire::MessageType::Canceled) throw rpc::CallError("the call was canceled");
  if (returns == "v" || answer.payload.empty()) return {};
  const bool dynamic = (answer.flags & wire::kFlagDynamic) != 0;
  wire::Decoder decoder(answer.payload);
  try {
    return decoder.read(dynamic ? "m" : returns);
  } catch (const wire::CodecError& error) {
    throw rpc::CallError(error.what());
  }
}

void Connection::send(const wire::Message& message) {
  const rpc::Bytes bytes = wire::encodeFrame(message);
  const std::lock_guard lock(sending_);
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0) return ::shutdown(socket_, SHUT_RDWR), void();  // the reader then tells it
    sent += static_cast<std::size_t>(count);
  }
}

void Connection::read() {
  wire::FrameReader frames;
  frames.setMaxPayload(wire::kMaxPayload);
  std::array<std::uint8_t, 65536> buffer;
  while (!frames.isBroken()) {
    const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    frames.push(buffer.data(), static_cast<std::size_t>(count));
    while (auto message = frames.next()) take(*std::move(message));
  }
  lose();
}

void Connection::take(wire::Message message) {
  switch (message.type) {
    case wire::MessageType::Reply:
    case wire::MessageType::Error:
    case wire::MessageType::Canceled: {
      const std::lock_guard lock(mutex_);
      const auto found = open_calls_.find(message.id);
      if (found == open_calls_.end()) return;
      found->second.set_value(std::move(message));
      open_calls_.erase(found);
      return;
    }
    case wire::MessageType::Call:
    case wire::MessageType::Post:
      return incoming_(message);
    case wire::MessageType::Event:
    case wire::MessageType::Capability:
    case wire::MessageType::Cancel:
      return;
  }
}

void Connection::lose() {
  const std::lock_guard lock(mutex_);
  lost_ = true;
  for (auto& [id, promise] : open_calls_) {
    promise.set_exception(std::make_exception_ptr(rpc::CallError(kGone)));
  }
  open_calls_.clear();
  if (!closing_ && reader_.joinable()) reader_.detach();  // its end is here: nobody joins it
}

bool Connection::isOpen() const {
  const std::lock_guard lock(mutex_);
  return !lost_;
}

void Connection::close() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  ::shutdown(socket_, SHUT_RDWR);
  if (!reader_.joinable()) return;
  reader_.get_id() == std::this_thread::get_id() ? reader_.detach() : reader_.join();
}

}  // namespace nao::client
