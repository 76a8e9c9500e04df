// A signature that can be read is written as it was, and read again as the same.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/check.h"
#include "naoqi_api/signature.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto type = nao::rpc::Signature::parse(text);
  if (!type) return 0;
  const auto again = nao::rpc::Signature::parse(type->text());
  NAO_CHECK(again && again->hasLayoutOf(*type) && again->text() == type->text());
  NAO_CHECK(!type->words().empty());
  return 0;
}
