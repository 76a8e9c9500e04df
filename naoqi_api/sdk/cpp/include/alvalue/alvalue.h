#pragma once

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <usarnaoqi_sdk/export.h>

namespace AL {

/// How toString() writes.
enum Verbosity { VerbosityMini };

/// NaoQi's value of any type: nothing, a bool, an int, a float, a text, bytes, or an array of such
/// values. Numbers and bools turn into each other when read, a text is never a number; reading a
/// value as something it can not be throws ALError.
class USARNAOQI_SDK_API ALValue {
 public:
  enum Type {
    TypeInvalid,
    TypeArray,
    TypeBool,
    TypeInt,
    TypeFloat,
    TypeString,
    TypeObject,
    TypeBinary
  };
  typedef int TALValueInt;
  typedef float TALValueFloat;
  typedef double TALValueDouble;
  typedef bool TALValueBool;
  typedef std::string TALValueString;
  typedef std::vector<unsigned char> TAlValueBinaryData;
  typedef TAlValueBinaryData::iterator ITAlValueBinaryData;
  typedef TAlValueBinaryData::const_iterator CITAlValueBinaryData;
  typedef std::vector<ALValue> TAlValueArray;
  typedef TAlValueArray::iterator ITAlValueArray;
  typedef TAlValueArray::const_iterator CITAlValueArray;
  typedef std::vector<std::string> TStringArray;
  typedef std::vector<float> TFloatArray;
  typedef std::vector<int> TIntArray;

  ALValue() : type_(TypeInvalid), number_() {}
  ALValue(const bool& truth) : type_(TypeBool) { number_.truth = truth; }
  ALValue(const int& number) : type_(TypeInt) { number_.whole = number; }
  ALValue(const float& number) : type_(TypeFloat) { number_.real = number; }
  ALValue(const double& number) : type_(TypeFloat) { number_.real = static_cast<float>(number); }
  ALValue(const char* text) : type_(TypeString), number_(), text_(text) {}
  ALValue(const std::string& text) : type_(TypeString), number_(), text_(text) {}
  /// Bytes, copied.
  ALValue(const void* bytes, int size) : number_() { SetBinary(bytes, size); }
  ALValue(const TAlValueBinaryData& bytes) : number_() {
    SetBinary(bytes.data(), static_cast<int>(bytes.size()));
  }
  /// Arrays of `count` items, copied.
  ALValue(const char** texts, int count) : number_() {
    assignAll(TStringArray(texts, texts + count));
  }
  ALValue(const float* numbers, int count) : number_() {
    assignAll(TFloatArray(numbers, numbers + count));
  }
  ALValue(const int* numbers, int count) : number_() {
    assignAll(TIntArray(numbers, numbers + count));
  }
  ALValue(const std::vector<ALValue>& items) : type_(TypeArray), number_(), items_(items) {}
  ALValue(const std::vector<std::string>& items) : number_() { assignAll(items); }
  ALValue(const std::vector<float>& items) : number_() { assignAll(items); }
  ALValue(const std::vector<double>& items) : number_() { assignAll(items); }
  ALValue(const std::vector<int>& items) : number_() { assignAll(items); }
  ALValue(const std::vector<bool>& items) : number_() { assignAll(items); }
  template <class T>
  ALValue(const std::vector<std::vector<T> >& items) : number_() {
    assignAll(items);
  }

  /// An array of what is given, each as a value of its own type.
  template <class... T>
  static ALValue array(const T&... items) {
    ALValue made;
    made.arraySetSize(0);
    const int all[] = {0, (made.arrayPush(ALValue(items)), 0)...};
    static_cast<void>(all);
    return made;
  }

  Type getType() const { return type_; }
  bool isValid() const { return type_ != TypeInvalid; }
  bool isArray() const { return type_ == TypeArray; }
  bool isBool() const { return type_ == TypeBool; }
  bool isInt() const { return type_ == TypeInt; }
  bool isFloat() const { return type_ == TypeFloat; }
  bool isString() const { return type_ == TypeString; }
  bool isBinary() const { return type_ == TypeBinary; }
  bool isObject() const { return type_ == TypeObject; }

  operator bool() const;
  operator int() const;
  operator float() const;
  operator double() const { return asNumber("a number"); }
  operator long long() const {
    return isInt() ? number_.whole : static_cast<long long>(asNumber("an int"));
  }
  operator const std::string&() const;
  /// To be written to; an invalid value becomes an empty text.
  operator std::string&();
  operator TAlValueBinaryData() const { return asRaw(); }
  /// The bytes: see GetBinary().
  explicit operator const void*() const { return GetBinary(); }
  operator std::vector<std::string>() const { return asVector<std::string>(); }
  operator std::vector<float>() const { return asVector<float>(); }
  operator std::vector<int>() const { return asVector<int>(); }
  operator std::vector<ALValue>() const { return asVector<ALValue>(); }

  /// The items that are texts, or numbers, or whole numbers; of any other, if `insert_default`, an
  /// empty text or 0. @throws ALError if this is no array.
  void ToStringArray(TStringArray& items, bool insert_default = false) const;
  void ToFloatArray(TFloatArray& items, bool insert_default = false) const;
  void ToIntArray(TIntArray& items, bool insert_default = false) const;

  /// Items of an array, bytes of a text, binary or object, 1 of any other value, 0 of none.
  unsigned int getSize() const;
  /// An invalid value becomes an array; one of another type throws. Items that are added are
  /// invalid.
  void arraySetSize(int size);
  void arrayReserve(int size);
  void arrayPush(const ALValue& item);
  void arrayPopFront();
  void arrayRemove(int index);
  /// The item at `index`. The writable form makes an array of an invalid value, and room for it.
  ALValue& operator[](int index);
  const ALValue& operator[](int index) const;

  /// Bytes: copied, kept as they are (whoever passes them keeps them alive), or asked for.
  void SetBinary(const void* bytes, int size);
  ALValue& SetBinaryNoCopy(const void* bytes, int size);
  void SetBinary(std::shared_ptr<const void> bytes, int size);
  const void* GetBinary() const;
  /// The same as an object, which only this process knows: a proxy sends nothing of it.
  ALValue& setObject(const void* bytes, int size);
  const void* getObject() const;
  /// The bytes of a binary or an object, copied. @throws ALError for any other.
  TAlValueBinaryData asRaw() const;

  /// The items themselves. @throws ALError if this is no array.
  TAlValueArray* getArrayPtr() const;
  /// The 32 bits of an int or float, or a bool, themselves. @throws ALError for any other.
  void* getPtrValue();
  int* getIntPtr();
  float* getFloatPtr();

  void clear() { *this = ALValue(); }

  /// As text: [1, "a", 0.5].
  std::string toString(Verbosity verbosity = VerbosityMini) const;
  /// "Invalid", "Array", "Bool", "Int", "Float", "String", "Object", "Binary".
  static std::string TypeToString(Type type);

  /// As a text that unSerializeFromText() makes the same value of. @throws ALError for bytes.
  std::string serializeToText() const;
  /// Of "[36, 3.5, true, 'a', \"b\"]", or its first `limit` characters; nothing of an empty text.
  /// @throws ALError for what is no value.
  void unSerializeFromText(const char* text, int limit = 0x7FFFFFFF);
  /// What unSerializeFromText() would make of it. @throws ALError
  static Type deduceType(const char* text, int limit = 0x7FFFFFFF);

  /// The bytes of a binary or an object in base 64 (RFC 4648). @throws ALError for any other.
  void encodeB64(std::string& text) const;
  /// Becomes a binary, or an object; false, and as it was, if the text is not base 64.
  bool decodeB64(const char* text);
  bool decodeB64Object(const char* text);

  bool operator==(const ALValue& other) const;
  bool operator!=(const ALValue& other) const { return !(*this == other); }

 private:
  union Number {
    Number() : whole(0) {}
    bool truth;
    int whole;
    float real;
  };

  double asNumber(const char* wanted) const;
  void fail(const char* wanted) const;

  template <class T>
  std::vector<T> asVector() const {
    std::vector<T> items;
    if (!isArray()) return items.push_back(static_cast<T>(*this)), items;
    for (std::size_t i = 0; i < items_.size(); ++i) items.push_back(static_cast<T>(items_[i]));
    return items;
  }
  bool isNumber() const { return isInt() || isFloat() || isBool(); }
  template <class T>
  void fill(std::vector<T>& items, bool insert_default, bool (ALValue::*fits)() const) const {
    if (!isArray()) fail("an array");
    items.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if ((items_[i].*fits)()) {
        items.push_back(static_cast<T>(items_[i]));
      } else if (insert_default) {
        items.push_back(T());
      }
    }
  }
  template <class T>
  void assignAll(const std::vector<T>& items) {
    type_ = TypeArray;
    items_.assign(items.begin(), items.end());
  }

  Type type_;
  Number number_;
  std::string text_;
  std::vector<ALValue> items_;
  std::shared_ptr<const void> bytes_;
  int byte_count_ = 0;
};

USARNAOQI_SDK_API std::ostream& operator<<(std::ostream& out, const ALValue& value);

namespace detail {

/// A list that a program writes as it is.
struct WrittenList {
  WrittenList(const std::vector<std::string>& items) : value(items) {}
  WrittenList(const std::vector<float>& items) : value(items) {}
  WrittenList(const std::vector<int>& items) : value(items) {}
  WrittenList(const std::vector<bool>& items) : value(items) {}

  ALValue value;
};

}  // namespace detail
}  // namespace AL

/// std::cout << motion.getAngles("Body", true): as an ALValue. A program's own operator goes
/// before.
inline std::ostream& operator<<(std::ostream& out, const AL::detail::WrittenList& list) {
  return out << list.value;
}
