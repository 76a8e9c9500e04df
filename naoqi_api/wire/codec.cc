#include "naoqi_api/wire/codec.h"

#include <algorithm>

#include "core/check.h"
#include "naoqi_api/wire/bytes.h"

namespace nao::wire {
namespace {

using rpc::SharedBytes;

[[noreturn]] void failPastEnd() { throw CodecError("ISerialization error Status Read Past End"); }

[[noreturn]] void failTooLarge() { throw CodecError("ISerialization error: too many values"); }

/// The least number of bytes a value of this type takes.
std::size_t leastSize(const Signature& signature) {
  switch (signature.kind()) {
    case 'b':
    case 'c':
    case 'C':
    case '+':
      return 1;
    case 'w':
    case 'W':
      return 2;
    case 'l':
    case 'L':
    case 'd':
      return 8;
    case 'v':
    case '_':
      return 0;
    case '(': {
      std::size_t sum = 0;
      for (const Signature& child : signature.children()) sum += leastSize(child);
      return sum;
    }
    default:
      return 4;
  }
}

}  // namespace

template <class T>
T Decoder::number() {
  return readNumber<T>(take(sizeof(T)));
}
template std::uint32_t Decoder::number<std::uint32_t>();
template std::uint8_t Decoder::number<std::uint8_t>();

const std::uint8_t* Decoder::take(std::size_t count) {
  if (count > left()) failPastEnd();
  const std::uint8_t* start = bytes_.data() + at_;
  at_ += count;
  return start;
}

std::string Decoder::text() {
  const auto size = number<std::uint32_t>();
  const std::uint8_t* start = take(size);
  return std::string(start, start + size);
}

Bytes Decoder::raw(std::size_t count) {
  const std::uint8_t* start = take(count);
  return Bytes(start, start + count);
}

void Decoder::spend(std::size_t& budget, std::size_t amount) {
  if (budget < amount) failTooLarge();
  budget -= amount;
}

std::string Decoder::typeText(const Signature& signature) {
  std::string text = signature.text();
  spend(budget_.type_letters, text.size());
  return text;
}

Value Decoder::read(const Signature& signature) { return readAt(signature, 0); }

Value Decoder::readAt(const Signature& signature, int depth) {
  if (depth > rpc::kMaxNesting) throw CodecError("ISerialization error: nested too deep");
  spend(budget_.values);
  const std::size_t before = at_;
  Value value = readKind(signature, depth);
  if (at_ == before) spend(budget_.empty_values);
  return value;
}

Value Decoder::readKind(const Signature& signature, int depth) {
  switch (signature.kind()) {
    case 'b':
      return number<std::uint8_t>() != 0;
    case 'c':
      return number<std::int8_t>();
    case 'C':
      return number<std::uint8_t>();
    case 'w':
      return number<std::int16_t>();
    case 'W':
      return number<std::uint16_t>();
    case 'i':
      return number<std::int32_t>();
    case 'I':
      return number<std::uint32_t>();
    case 'l':
      return number<std::int64_t>();
    case 'L':
      return number<std::uint64_t>();
    case 'f':
      return number<float>();
    case 'd':
      return number<double>();
    case 's':
      return text();
    case 'r':
      return Value::raw(raw(number<std::uint32_t>()));
    case 'm':
      return readDynamic(depth);
    case '[':
    case '#':
      return readList(signature.children().front(), depth);
    case '{':
      return readMap(signature, depth);
    case '(':
      return readTuple(signature, depth);
    case '+':
      return readOptional(signature.children().front(), depth);
    case 'o':
      if (!objects_) throw CodecError("ISerialization error: no object is expected here");
      return objects_->decode(*this);
    case 'v':
    case '_':
      return {};
    default:
      throw CodecError("ISerialization error: " + signature.text() + " can not be read");
  }
}

Value Decoder::readDynamic(int depth) {
  const std::string text = this->text();
  if (text.empty()) return Value::invalid();
  spend(budget_.signature_letters, text.size());
  const auto signature = Signature::parse(text);
  if (!signature) throw CodecError("ISerialization error: bad signature " + text.substr(0, 80));
  Value value = readAt(*signature, depth + 1);
  return signature->is('m') ? Value::dynamic(std::move(value)) : value;
}

// The count of items that follows, if that many can be left.
std::size_t Decoder::count(const Signature& element) {
  const std::size_t count = number<std::uint32_t>();
  const std::size_t least = leastSize(element);
  if (least == 0 && count > budget_.empty_values) failTooLarge();
  if (least > 0 && count > left() / least) failPastEnd();
  if (count > budget_.values) failTooLarge();
  return count;
}

// What is claimed is not yet there: room is made for the first items only.
constexpr std::size_t kRoomAhead = 1024;

Value Decoder::readList(const Signature& element, int depth) {
  std::string type = typeText(element);
  const std::size_t size = count(element);
  std::vector<Value> items;
  items.reserve(std::min(size, kRoomAhead));
  for (std::size_t i = 0; i < size; ++i) items.push_back(readAt(element, depth + 1));
  return Value::listOf(std::move(type), std::move(items));
}

Value Decoder::readMap(const Signature& signature, int depth) {
  const Signature& key = signature.children()[0];
  const Signature& value = signature.children()[1];
  Value::Map map{typeText(key), typeText(value), {}};
  const std::size_t size = count(key);
  map.entries.reserve(std::min(size, kRoomAhead));
  for (std::size_t i = 0; i < size; ++i) {
    Value entry_key = readAt(key, depth + 1);
    map.entries.emplace_back(std::move(entry_key), readAt(value, depth + 1));
  }
  return map;
}

Value Decoder::readTuple(const Signature& signature, int depth) {
  std::string type = typeText(signature);
  std::vector<Value> items;
  items.reserve(signature.children().size());
  for (const Signature& child : signature.children()) items.push_back(readAt(child, depth + 1));
  return Value::tuple(std::move(type), std::move(items));
}

Value Decoder::readOptional(const Signature& element, int depth) {
  Value::Optional optional{typeText(element), {}};
  if (number<std::uint8_t>() != 0) optional.item.push_back(readAt(element, depth + 1));
  return optional;
}

namespace {

// The letters of Value's alternatives, in their order.
constexpr char kKinds[] = "v\0bcCwWiIlLfdsr[{(+mo";
static_assert(sizeof(kKinds) - 1 == std::variant_size_v<Value::Content>);

bool isOfKind(const Value& value, char kind) {
  const char own = kKinds[value.content().index()];
  return own == kind || (own == 'v' && kind == '_') || (own == '[' && kind == '#');
}

class Encoder {
 public:
  Encoder(Bytes& out, ObjectCodec* objects) : out_(out), objects_(objects) {}

  void write(const Value& value, const Signature& signature) {
    if (signature.is('m')) return writeDynamic(value);
    NAO_CHECK(isOfKind(value, signature.kind()));
    signature_ = &signature;
    std::visit(*this, value.content());
  }

  void writeDynamic(const Value& value) {
    const std::string text = value.signature();
    appendText(out_, text);
    if (text.empty()) return;
    if (const auto* dynamic = std::get_if<Value::Dynamic>(&value.content())) {
      return writeDynamic(*dynamic->inner);
    }
    // A client's value inside a tuple of ours may be nested deeper than any type may be.
    const auto signature = Signature::parse(text);
    if (!signature) throw CodecError("ISerialization error: nested too deep");
    write(value, *signature);
  }

  void operator()(const Value::Void& /*none*/) {}
  void operator()(const Value::Invalid& /*none*/) {}
  void operator()(bool truth) { appendNumber<std::uint8_t>(out_, truth ? 1 : 0); }
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  void operator()(T number) {
    appendNumber(out_, number);
  }
  void operator()(const std::string& text) { appendText(out_, text); }
  void operator()(const SharedBytes& bytes) {
    appendNumber(out_, static_cast<std::uint32_t>(bytes->size()));
    out_.insert(out_.end(), bytes->begin(), bytes->end());
  }
  void operator()(const Value::List& list) {
    const Signature& element = signature_->children().front();
    appendNumber(out_, static_cast<std::uint32_t>(list.items.size()));
    for (const Value& item : list.items) write(item, element);
  }
  void operator()(const Value::Map& map) {
    const auto& types = signature_->children();
    appendNumber(out_, static_cast<std::uint32_t>(map.entries.size()));
    for (const auto& [key, value] : map.entries) {
      write(key, types[0]);
      write(value, types[1]);
    }
  }
  void operator()(const Value::Tuple& tuple) {
    const auto& types = signature_->children();
    NAO_CHECK(types.size() == tuple.items.size());
    for (std::size_t i = 0; i < types.size(); ++i) write(tuple.items[i], types[i]);
  }
  void operator()(const Value::Optional& optional) {
    const Signature& element = signature_->children().front();
    appendNumber<std::uint8_t>(out_, optional.item.empty() ? 0 : 1);
    for (const Value& item : optional.item) write(item, element);
  }
  void operator()(const Value::Dynamic& dynamic) { writeDynamic(*dynamic.inner); }
  void operator()(const ObjectRef& object) {
    NAO_CHECK(objects_ != nullptr);
    objects_->encode(out_, object);
  }

 private:
  Bytes& out_;
  ObjectCodec* objects_;
  const Signature* signature_ = nullptr;  // of the value that is being visited
};

}  // namespace

void encode(Bytes& out, const Value& value, const Signature& signature, ObjectCodec* objects) {
  Encoder(out, objects).write(value, signature);
}

void encodeDynamic(Bytes& out, const Value& value, ObjectCodec* objects) {
  Encoder(out, objects).writeDynamic(value);
}

}  // namespace nao::wire
