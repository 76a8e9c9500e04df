// Whatever a page sends, one body of messages per line.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "naoqi_api/wire/qijs_connection.h"
#include "naoqi_api/wire/socket_io.h"
#include "tests/naoqi_api/test_client.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nao;
  wire::DemoHub demo;
  wire::QijsConnection page(
      demo.hub, "tcp://127.0.0.1:1", [](const std::string&) {}, [] {});
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  bool goes_on = true;
  while (goes_on && !rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const auto packets = nao::wire::splitPackets(line);
    goes_on = packets.has_value();
    for (std::size_t k = 0; goes_on && k < packets->size(); ++k)
      goes_on = page.receive((*packets)[k]);
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  }
  demo.demo.finishSlowCalls();
  return 0;
}
