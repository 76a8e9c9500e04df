// Whatever bytes a client sends, in whatever pieces: answers, errors or a closed connection.
#include <cstddef>
#include <cstdint>

#include "naoqi_api/wire/qi_connection.h"
#include "tests/naoqi_api/test_client.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  using namespace nao;
  const bool strict = (data[0] & 1U) != 0;
  wire::DemoHub demo(strict ? rpc::Personality::libqi4() : rpc::Personality::naoqi());
  wire::QiConnection client(demo.hub, "tcp://127.0.0.1:9559", [](const wire::Bytes&) {});
  const std::size_t piece = 1U + data[1] * 8U;
  for (std::size_t at = 2; at < size && !client.wantsClose(); at += piece) {
    client.receive(data + at, std::min(piece, size - at));
  }
  demo.demo.finishSlowCalls();
  return 0;
}
