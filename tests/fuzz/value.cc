// A dynamic that can be read is written in no more bytes, and read again as the same.
#include <cstddef>
#include <cstdint>

#include "core/check.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/wire/codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nao;
  const wire::Bytes bytes(data, data + size);
  try {
    const rpc::Value value = wire::Decoder(bytes).read("m");
    wire::Bytes written;
    wire::encodeDynamic(written, value);
    wire::Bytes again;
    wire::encodeDynamic(again, wire::Decoder(written).read("m"));
    NAO_CHECK(again == written);
    for (const char* type : {"b", "i", "L", "f", "s", "[s]", "[m]", "{sm}", "(si)", "+d"}) {
      for (const auto bend : {rpc::Bend::Declared, rpc::Bend::Loose}) {
        const auto signature = rpc::Signature::of(type);
        const auto bent = rpc::convert(value, signature, bend);
        wire::Bytes sent;
        if (bent) wire::encode(sent, *bent, signature);
      }
    }
  } catch (const wire::CodecError&) {
    return 0;
  }
  return 0;
}
