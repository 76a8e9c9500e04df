#include "naoqi_api/wire/json_codec.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/value_builder.h"

namespace nao::wire {
namespace {

using Json = nlohmann::json;
using rpc::Value;

/// Takes what nlohmann's parser meets.
class Sax {
 public:
  bool null() { return builder_.put(Value()); }
  bool boolean(bool truth) { return builder_.put(truth); }
  bool number_integer(Json::number_integer_t number) { return builder_.putInteger(number); }
  bool number_unsigned(Json::number_unsigned_t number) { return builder_.putInteger(number); }
  bool number_float(Json::number_float_t number, const std::string& /*text*/) {
    return builder_.put(number);
  }
  bool string(std::string& text) { return builder_.put(text); }
  bool binary(Json::binary_t& /*bytes*/) { return builder_.fail(); }
  bool start_object(std::size_t /*count*/) { return builder_.open(); }
  bool key(std::string& text) { return builder_.put(text); }
  bool end_object() { return builder_.closeMap("s"); }
  bool start_array(std::size_t /*count*/) { return builder_.open(); }
  bool end_array() { return builder_.closeList(); }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) {
    return builder_.fail();
  }

  std::optional<Value> take() {
    if (!builder_.isWhole()) return std::nullopt;
    return builder_.takeResult();
  }

 private:
  ValueBuilder builder_;
};

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::optional<Value> readJson(std::string_view text) {
  Sax sax;
  if (!Json::sax_parse(text.begin(), text.end(), &sax)) return std::nullopt;
  return sax.take();
}

template <class T>
void JsonWriter::writeNumber(T number) {
  if constexpr (std::is_same_v<T, bool>) {
    json_ += number ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(number)) throw rpc::CallError("JSON has no number that is not finite");
    json_ += nlohmann::json(number).dump();
  } else {
    json_ += std::to_string(number);
  }
}

void JsonWriter::writeText(const std::string& text) { json_ += quoted(text); }

void JsonWriter::writeItems(const std::vector<Value>& items) {
  json_ += '[';
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) json_ += ',';
    write(items[i]);
  }
  json_ += ']';
}

void JsonWriter::writeMap(const Value::Map& map) {
  json_ += '{';
  for (std::size_t i = 0; i < map.entries.size(); ++i) {
    const auto& [key, value] = map.entries[i];
    if (i > 0) json_ += ',';
    const std::string* text = key.findText();
    writeText(text ? *text : key.print());
    json_ += ':';
    write(value);
  }
  json_ += '}';
}

void JsonWriter::write(const Value& value) {
  const Value& bare = value.bare();
  if (bare.isVoid()) {
    json_ += "null";
  } else if (const std::string* text = bare.findText()) {
    writeText(*text);
  } else if (const auto* items = bare.findItems()) {
    writeItems(*items);
  } else if (const auto* map = bare.find<Value::Map>()) {
    writeMap(*map);
  } else if (const auto* optional = bare.find<Value::Optional>()) {
    write(optional->item.empty() ? Value() : optional->item.front());
  } else if (const auto* object = bare.find<rpc::ObjectRef>()) {
    json_ += json_of_(*object);
  } else if (const auto* bytes = bare.find<rpc::SharedBytes>()) {
    json_ += '[';
    for (std::size_t i = 0; *bytes && i < (*bytes)->size(); ++i) {
      if (i > 0) json_ += ',';
      json_ += std::to_string((**bytes)[i]);
    }
    json_ += ']';
  } else {
    std::visit(
        [this](const auto& number) {
          if constexpr (std::is_arithmetic_v<std::decay_t<decltype(number)>>) writeNumber(number);
        },
        bare.content());
  }
}

}  // namespace nao::wire
