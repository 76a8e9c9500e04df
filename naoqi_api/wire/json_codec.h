#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "naoqi_api/value.h"
#include "naoqi_api/wire/msgpack_codec.h"

namespace nao::wire {

/// The value of a JSON text: an array is [m], an object {sm}, a number i, l, L or d, null is void.
/// Nothing if it is no JSON, nested too deep or has too many parts.
std::optional<rpc::Value> readJson(std::string_view text);

/// Writes JSON piece by piece.
class JsonWriter {
 public:
  /// `json_of` writes an object that is passed to the client as JSON.
  explicit JsonWriter(const NameOf& json_of) : json_of_(json_of) {}

  /// Appends `value`: raw bytes as a list of numbers, a tuple as an array, text that is no UTF-8
  /// with U+FFFD in place of what is wrong. @throws rpc::CallError for NaN and infinity
  void write(const rpc::Value& value);
  void writeText(const std::string& text);
  void writeRaw(std::string_view json) { json_ += json; }

  const std::string& json() const { return json_; }

 private:
  template <class T>
  void writeNumber(T number);
  void writeItems(const std::vector<rpc::Value>& items);
  void writeMap(const rpc::Value::Map& map);

  const NameOf& json_of_;
  std::string json_;
};

}  // namespace nao::wire
