// Whatever bytes a client of the MessagePack-RPC port sends, in whatever pieces.
#include <cstddef>
#include <cstdint>

#include "naoqi_api/wire/msgpack_connection.h"
#include "tests/naoqi_api/test_client.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  using namespace nao;
  wire::DemoHub demo;
  wire::MsgpackConnection client(demo.hub, "tcp://127.0.0.1:1", [](const wire::Bytes&) {});
  const std::size_t piece = 1U + data[0] * 8U;
  for (std::size_t at = 1; at < size && !client.wantsClose(); at += piece) {
    client.receive(data + at, std::min(piece, size - at));
  }
  demo.demo.finishSlowCalls();
  return 0;
}
