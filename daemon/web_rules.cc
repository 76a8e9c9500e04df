#include "daemon/web_rules.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <boost/beast/core/detail/base64.hpp>

namespace nao::daemon {
namespace {

// "[::1]:8002" -> "::1", "localhost:80" -> "localhost"
std::string withoutPort(const std::string& host) {
  if (!host.empty() && host.front() == '[') {
    const std::size_t end = host.find(']');
    return end == host.npos ? std::string() : host.substr(1, end - 1);
  }
  return host.substr(0, host.find(':'));
}

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

std::string decodeBase64(std::string_view text) {
  namespace base64 = boost::beast::detail::base64;
  std::string decoded(base64::decoded_size(text.size()), '\0');
  const auto sizes = base64::decode(decoded.data(), text.data(), text.size());
  decoded.resize(sizes.first);
  return decoded;
}

}  // namespace

bool isAllowed(const WebAddress& address, const std::string& own_name,
               const std::vector<std::string>& origins) {
  const std::string host = withoutPort(address.host);
  boost::system::error_code not_an_address;
  boost::asio::ip::make_address(host, not_an_address);
  if (not_an_address && host != "localhost" && host != own_name) return false;
  if (address.origin.empty()) return true;
  if (address.origin == "http://" + address.host) return true;
  return std::find(origins.begin(), origins.end(), address.origin) != origins.end();
}

bool isAuthorized(std::string_view header, const rpc::Credentials& credentials) {
  constexpr std::string_view kScheme = "Basic ";
  constexpr std::size_t kLongest = 4 * rpc::Credentials::kLongest;
  if (!startsWith(header, kScheme) || header.size() > kLongest) return false;
  const std::string pair = decodeBase64(header.substr(kScheme.size()));
  const std::size_t colon = pair.find(':');
  if (colon == pair.npos) return false;
  return credentials.accept(pair.substr(0, colon), pair.substr(colon + 1));
}

WebRequest readTarget(std::string_view target) {
  using Kind = WebRequest::Kind;
  target = target.substr(0, target.find('?'));
  if (target == "/" || target == "/index.html") return {Kind::Page, {}};
  for (const std::string_view script :
       {"/libs/qi/2/qi.js", "/libs/qi/1.0/qi.js", "/libs/qimessaging/2/qimessaging.js",
        "/libs/qimessaging/1.0/qimessaging.js"}) {
    if (target == script) return {Kind::Script, {}};
  }
  for (const std::string_view version :
       {"/libs/qimessaging/2/socket.io/1/", "/libs/qimessaging/1.0/socket.io/1/"}) {
    if (!startsWith(target, version)) continue;
    const std::string_view rest = target.substr(version.size());
    constexpr std::string_view kSocket = "websocket/";
    constexpr std::string_view kPoll = "xhr-polling/";
    if (rest.empty()) return {Kind::Handshake, {}};
    if (startsWith(rest, kSocket)) return {Kind::Socket, std::string(rest.substr(kSocket.size()))};
    if (startsWith(rest, kPoll)) return {Kind::Poll, std::string(rest.substr(kPoll.size()))};
  }
  return {};
}

}  // namespace nao::daemon
