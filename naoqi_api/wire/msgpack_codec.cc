#include "naoqi_api/wire/msgpack_codec.h"

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <msgpack.hpp>
#pragma GCC diagnostic pop

#include "naoqi_api/wire/value_builder.h"

namespace nao::wire {
namespace {

using rpc::Bytes;
using rpc::SharedBytes;
using rpc::Value;

struct Output {
  Bytes& bytes;
  void write(const char* data, std::size_t count) { bytes.insert(bytes.end(), data, data + count); }
};

class Packer {
 public:
  Packer(Bytes& out, const NameOf& name_of) : output_{out}, packer_(output_), name_of_(name_of) {}

  void pack(const Value& value) { std::visit(*this, value.content()); }

  void operator()(const Value::Void& /*none*/) { packer_.pack_nil(); }
  void operator()(const Value::Invalid& /*none*/) { packer_.pack_nil(); }
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  void operator()(T number) {
    packer_.pack(number);
  }
  void operator()(const std::string& text) { packer_.pack(text); }
  void operator()(const SharedBytes& bytes) {
    const auto size = static_cast<std::uint32_t>(bytes ? bytes->size() : 0);
    packer_.pack_bin(size);
    if (size > 0) packer_.pack_bin_body(reinterpret_cast<const char*>(bytes->data()), size);
  }
  void operator()(const Value::List& list) { packItems(list.items); }
  void operator()(const Value::Tuple& tuple) { packItems(tuple.items); }
  void operator()(const Value::Map& map) {
    packer_.pack_map(static_cast<std::uint32_t>(map.entries.size()));
    for (const auto& [key, value] : map.entries) {
      pack(key);
      pack(value);
    }
  }
  void operator()(const Value::Optional& optional) {
    if (optional.item.empty()) return (*this)(Value::Void());
    pack(optional.item.front());
  }
  void operator()(const Value::Dynamic& dynamic) { pack(*dynamic.inner); }
  void operator()(const rpc::ObjectRef& object) { packer_.pack(name_of_(object)); }

 private:
  void packItems(const std::vector<Value>& items) {
    packer_.pack_array(static_cast<std::uint32_t>(items.size()));
    for (const Value& item : items) pack(item);
  }

  Output output_;
  msgpack::packer<Output> packer_;
  const NameOf& name_of_;
};

/// Builds the value that the parser walks through.
class Visitor : public msgpack::null_visitor {
 public:
  bool visit_nil() { return builder.put(Value()); }
  bool visit_boolean(bool truth) { return builder.put(truth); }
  bool visit_positive_integer(std::uint64_t number) { return builder.putInteger(number); }
  bool visit_negative_integer(std::int64_t number) { return builder.putInteger(number); }
  bool visit_float32(float number) { return builder.put(number); }
  bool visit_float64(double number) { return builder.put(number); }
  bool visit_str(const char* text, std::uint32_t size) {
    return builder.put(std::string(text, size));
  }
  bool visit_bin(const char* bytes, std::uint32_t size) {
    return builder.put(Value::raw(Bytes(bytes, bytes + size)));
  }
  bool visit_ext(const char* /*bytes*/, std::uint32_t /*size*/) { return builder.fail(); }
  bool start_array(std::uint32_t /*count*/) { return builder.open(); }
  bool end_array() { return builder.closeList(); }
  bool start_map(std::uint32_t /*count*/) { return builder.open(); }
  bool end_map() { return builder.closeMap("m"); }
  void parse_error(std::size_t /*parsed*/, std::size_t /*error*/) { builder.fail(); }

  void init() {}  // the parser begins another value

  ValueBuilder builder;
};

struct NoHook {
  void operator()(char* /*buffer*/) const {}
};

NoHook no_hook;  // has no state

}  // namespace

void packValue(Bytes& out, const Value& value, const NameOf& name_of) {
  Packer(out, name_of).pack(value);
}

class MsgpackReader::Impl : public msgpack::parser<MsgpackReader::Impl, NoHook> {
 public:
  Impl() : msgpack::parser<Impl, NoHook>(no_hook, kRoom) {}

  Visitor& visitor() { return visitor_; }
  bool referenced() const { return false; }  // texts are copied
  void set_referenced(bool /*is*/) {}
  ValueBuilder& builder() { return visitor_.builder; }

  static constexpr std::size_t kRoom = 4096;
  std::size_t max_bytes = kMaxBytes;
  bool broken = false;

 private:
  Visitor visitor_;
};

MsgpackReader::MsgpackReader() : impl_(std::make_unique<Impl>()) {}
MsgpackReader::~MsgpackReader() = default;

void MsgpackReader::setMaxBytes(std::size_t most) { impl_->max_bytes = most; }

void MsgpackReader::push(const std::uint8_t* bytes, std::size_t count) {
  if (impl_->broken) return;
  impl_->reserve_buffer(count);
  std::memcpy(impl_->buffer(), bytes, count);
  impl_->buffer_consumed(count);
}

std::optional<Value> MsgpackReader::next() {
  if (impl_->broken) return std::nullopt;
  const bool whole = impl_->msgpack::parser<Impl, NoHook>::next();
  if (impl_->builder().hasFailed() || (!whole && impl_->message_size() > impl_->max_bytes)) {
    impl_->broken = true;
  }
  if (!whole || impl_->broken) return std::nullopt;
  impl_->reset();
  return impl_->builder().takeResult();
}

bool MsgpackReader::isBroken() const { return impl_->broken; }

std::size_t MsgpackReader::bytesHeld() const {
  return impl_->nonparsed_size() + impl_->builder().valueCount() * sizeof(Value);
}

}  // namespace nao::wire
