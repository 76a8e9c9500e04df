#include <alvalue/alvalue.h>

#include <cstdint>
#include <cstring>
#include <optional>

// Base 64 (RFC 4648, section 4): three bytes as four letters, a missing byte's as '='.

namespace AL {
namespace {

const char* const kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

using Bytes = ALValue::TAlValueBinaryData;

std::string encode(const Bytes& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? kLetters[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::optional<Bytes> decode(const std::string& text) {
  if (text.size() % 4 != 0) return std::nullopt;
  const std::size_t letters = std::min(text.find('='), text.size());
  if (text.size() - letters > 2 || text.find_first_not_of('=', letters) != std::string::npos)
    return std::nullopt;
  Bytes bytes;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < letters; ++i) {
    const char* found = std::strchr(kLetters, text[i]);
    if (found == nullptr || *found == '\0') return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(found - kLetters);
    if (i % 4 != 0) bytes.push_back(static_cast<unsigned char>(bits >> (6 - 2 * (i % 4)) & 255U));
  }
  return bytes;
}

}  // namespace

void ALValue::encodeB64(std::string& text) const { text = encode(asRaw()); }

bool ALValue::decodeB64(const char* text) {
  const auto bytes = decode(text);
  if (bytes) SetBinary(bytes->data(), static_cast<int>(bytes->size()));
  return bytes.has_value();
}

bool ALValue::decodeB64Object(const char* text) {
  const bool is_base64 = decodeB64(text);
  if (is_base64) type_ = TypeObject;
  return is_base64;
}

}  // namespace AL
