#include "naoqi_api/signature.h"

#include <algorithm>

#include "core/check.h"

namespace nao::rpc {

/// Reads one type after another from a text; every step is false where the text is wrong.
class SignatureParser {
 public:
  explicit SignatureParser(std::string_view text) : text_(text) {}

  bool readOne(Signature& type, int depth) {
    if (depth > kMaxNesting || at_ == text_.size()) return false;
    type.kind_ = text_[at_++];
    return readChildren(type, depth) && readAnnotation(type.annotation_);
  }

  bool atEnd() const { return at_ == text_.size(); }

 private:
  bool readChildren(Signature& type, int depth) {
    switch (type.kind_) {
      case '[':
        return readMany(type, 1, depth) && take(']');
      case '{':
        return readMany(type, 2, depth) && take('}');
      case '(':
        while (at_ < text_.size() && text_[at_] != ')') {
          if (!readMany(type, 1, depth)) return false;
        }
        return take(')');
      case '+':
      case '#':
      case '~':
        return readMany(type, 1, depth);
      default:
        return std::string_view("bcCwWiIlLfdsrmov_X*").find(type.kind_) != std::string_view::npos;
    }
  }

  bool readMany(Signature& type, int count, int depth) {
    for (int i = 0; i < count; ++i) {
      if (!readOne(type.children_.emplace_back(), depth + 1)) return false;
    }
    return true;
  }

  bool readAnnotation(std::string& annotation) {
    if (at_ == text_.size() || text_[at_] != '<') return true;
    const std::size_t start = at_ + 1;
    int open = 0;
    for (; at_ < text_.size(); ++at_) {
      open += (text_[at_] == '<') - (text_[at_] == '>');
      if (open == 0) {
        annotation = text_.substr(start, at_++ - start);
        return true;
      }
    }
    return false;
  }

  bool take(char wanted) { return at_ < text_.size() && text_[at_++] == wanted; }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::optional<Signature> Signature::parse(std::string_view text) {
  if (text.size() > kMaxSignature) return std::nullopt;
  Signature type;
  SignatureParser parser(text);
  if (!parser.readOne(type, 0) || !parser.atEnd()) return std::nullopt;
  return type;
}

Signature Signature::of(std::string_view text) {
  auto type = parse(text);
  NAO_CHECK(type.has_value());
  return *std::move(type);
}

std::string Signature::text() const {
  std::string text(1, kind_);
  for (const Signature& child : children_) text += child.text();
  if (kind_ == '[') text += ']';
  if (kind_ == '{') text += '}';
  if (kind_ == '(') text += ')';
  if (!annotation_.empty()) text += '<' + annotation_ + '>';
  return text;
}

namespace {

std::string wordOf(char kind) {
  switch (kind) {
    case 'b':
      return "Bool";
    case 'c':
      return "Int8";
    case 'C':
      return "UInt8";
    case 'w':
      return "Int16";
    case 'W':
      return "UInt16";
    case 'i':
      return "Int32";
    case 'I':
      return "UInt32";
    case 'l':
      return "Int64";
    case 'L':
      return "UInt64";
    case 'f':
      return "Float";
    case 'd':
      return "Double";
    case 's':
      return "String";
    case 'r':
      return "RawBuffer";
    case 'm':
      return "Value";
    case 'o':
      return "Object";
    case 'v':
      return "Void";
    case '_':
      return "None";
    default:
      return "Unknown";
  }
}

}  // namespace

std::string Signature::words() const {
  std::string inner;
  for (const Signature& child : children_) inner += (inner.empty() ? "" : ",") + child.words();
  switch (kind_) {
    case '[':
      return "List<" + inner + ">";
    case '{':
      return "Map<" + inner + ">";
    case '(':
      return "(" + inner + ")";
    case '+':
      return "Optional<" + inner + ">";
    case '#':
      return "VarArgs<" + inner + ">";
    case '~':
      return "KwArgs<" + inner + ">";
    default:
      return wordOf(kind_);
  }
}

bool Signature::hasLayoutOf(const Signature& other) const {
  return kind_ == other.kind_ &&
         std::equal(children_.begin(), children_.end(), other.children_.begin(),
                    other.children_.end(),
                    [](const Signature& a, const Signature& b) { return a.hasLayoutOf(b); });
}

}  // namespace nao::rpc
