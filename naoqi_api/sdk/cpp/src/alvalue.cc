#include <alerror/alerror.h>
#include <alvalue/alvalue.h>

#include <cstring>
#include <sstream>

namespace AL {
namespace {

const char* const kKinds[] = {"nothing", "an array", "a bool",    "an int",
                              "a float", "a string", "an object", "bytes"};

}  // namespace

void ALValue::fail(const char* wanted) const {
  throw ALError("ALValue", "operator=",
                std::string("expected ") + wanted + ", found " + kKinds[type_] +
                    (isValid() ? ": " + toString() : std::string()));
}

double ALValue::asNumber(const char* wanted) const {
  if (isInt()) return number_.whole;
  if (isFloat()) return number_.real;
  if (isBool()) return number_.truth ? 1 : 0;
  fail(wanted);
  return 0;
}

ALValue::operator bool() const {
  if (isBool()) return number_.truth;
  return asNumber("a bool") != 0;
}

ALValue::operator int() const {
  if (isInt()) return number_.whole;
  return static_cast<int>(asNumber("an int"));
}

ALValue::operator float() const {
  if (isFloat()) return number_.real;
  return static_cast<float>(asNumber("a float"));
}

ALValue::operator const std::string&() const {
  if (!isString()) fail("a string");
  return text_;
}

ALValue::operator std::string&() {
  if (!isValid()) *this = std::string();
  if (!isString()) fail("a string");
  return text_;
}

unsigned int ALValue::getSize() const {
  if (isArray()) return static_cast<unsigned int>(items_.size());
  if (isString()) return static_cast<unsigned int>(text_.size());
  if (isBinary() || isObject()) return static_cast<unsigned int>(byte_count_);
  return isValid() ? 1 : 0;
}

void ALValue::arraySetSize(int size) {
  if (isValid() && !isArray()) fail("an array");
  type_ = TypeArray;
  items_.resize(static_cast<std::size_t>(size < 0 ? 0 : size));
}

void ALValue::arrayReserve(int size) {
  if (isValid() && !isArray()) fail("an array");
  type_ = TypeArray;
  items_.reserve(static_cast<std::size_t>(size < 0 ? 0 : size));
}

void ALValue::arrayPush(const ALValue& item) {
  if (isValid() && !isArray()) fail("an array");
  type_ = TypeArray;
  items_.push_back(item);
}

void ALValue::arrayPopFront() { arrayRemove(0); }

void ALValue::arrayRemove(int index) {
  if (!isArray()) fail("an array");
  if (index < 0 || index >= static_cast<int>(items_.size())) fail("an array with that item");
  items_.erase(items_.begin() + index);
}

ALValue& ALValue::operator[](int index) {
  if (isValid() && !isArray()) fail("an array");
  if (index < 0) fail("an index of 0 or more");
  if (static_cast<std::size_t>(index) >= items_.size()) arraySetSize(index + 1);
  return items_[static_cast<std::size_t>(index)];
}

const ALValue& ALValue::operator[](int index) const {
  if (!isArray()) fail("an array");
  if (index < 0 || static_cast<std::size_t>(index) >= items_.size()) {
    throw ALError("ALValue", "operator[]",
                  "expected an index below " + std::to_string(items_.size()) + ", found " +
                      std::to_string(index));
  }
  return items_[static_cast<std::size_t>(index)];
}

void ALValue::SetBinary(const void* bytes, int size) {
  const std::shared_ptr<std::string> copy = std::make_shared<std::string>(
      static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  SetBinary(std::shared_ptr<const void>(copy, copy->data()), size);
}

ALValue& ALValue::SetBinaryNoCopy(const void* bytes, int size) {
  SetBinary(std::shared_ptr<const void>(std::shared_ptr<const void>(), bytes), size);
  return *this;
}

void ALValue::SetBinary(std::shared_ptr<const void> bytes, int size) {
  type_ = TypeBinary;
  bytes_ = std::move(bytes);
  byte_count_ = size;
}

const void* ALValue::GetBinary() const {
  if (!isBinary()) fail("bytes");
  return bytes_.get();
}

ALValue& ALValue::setObject(const void* bytes, int size) {
  SetBinary(bytes, size);
  type_ = TypeObject;
  return *this;
}

const void* ALValue::getObject() const {
  if (!isObject()) fail("an object");
  return bytes_.get();
}

ALValue::TAlValueBinaryData ALValue::asRaw() const {
  if (!isBinary() && !isObject()) fail("bytes");
  const auto* first = static_cast<const unsigned char*>(bytes_.get());
  return {first, first + byte_count_};
}

ALValue::TAlValueArray* ALValue::getArrayPtr() const {
  if (!isArray()) fail("an array");
  return const_cast<TAlValueArray*>(&items_);
}

void* ALValue::getPtrValue() {
  if (!isBool() && !isInt() && !isFloat()) fail("a number");
  return &number_;
}

int* ALValue::getIntPtr() {
  if (!isInt()) fail("an int");
  return &number_.whole;
}

float* ALValue::getFloatPtr() {
  if (!isFloat()) fail("a float");
  return &number_.real;
}

void ALValue::ToStringArray(TStringArray& items, bool insert_default) const {
  fill(items, insert_default, &ALValue::isString);
}

void ALValue::ToFloatArray(TFloatArray& items, bool insert_default) const {
  fill(items, insert_default, &ALValue::isNumber);
}

void ALValue::ToIntArray(TIntArray& items, bool insert_default) const {
  fill(items, insert_default, &ALValue::isInt);
}

std::string ALValue::TypeToString(Type type) {
  static const char* const kNames[] = {"Invalid", "Array",  "Bool",   "Int",
                                       "Float",   "String", "Object", "Binary"};
  return kNames[type];
}

std::string ALValue::toString(Verbosity /*verbosity*/) const {
  std::ostringstream text;
  switch (type_) {
    case TypeInvalid:
      break;
    case TypeArray:
      text << '[';
      for (std::size_t i = 0; i < items_.size(); ++i) {
        text << (i == 0 ? "" : ", ") << items_[i].toString();
      }
      text << ']';
      break;
    case TypeBool:
      text << (number_.truth ? "true" : "false");
      break;
    case TypeInt:
      text << number_.whole;
      break;
    case TypeFloat:
      text << number_.real;
      break;
    case TypeString:
      text << '"' << text_ << '"';
      break;
    case TypeObject:
    case TypeBinary:
      text << '<' << byte_count_ << " bytes>";
      break;
  }
  return text.str();
}

bool ALValue::operator==(const ALValue& other) const {
  if (type_ != other.type_) return false;
  switch (type_) {
    case TypeArray:
      return items_ == other.items_;
    case TypeBool:
      return number_.truth == other.number_.truth;
    case TypeInt:
      return number_.whole == other.number_.whole;
    case TypeFloat:
      return number_.real == other.number_.real;
    case TypeString:
      return text_ == other.text_;
    case TypeObject:
    case TypeBinary:
      return byte_count_ == other.byte_count_ &&
             std::memcmp(bytes_.get(), other.bytes_.get(), static_cast<std::size_t>(byte_count_)) ==
                 0;
    case TypeInvalid:
      break;
  }
  return true;
}

std::ostream& operator<<(std::ostream& out, const ALValue& value) {
  return out << value.toString();
}

}  // namespace AL
