#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nao::rpc {

// A qi signature names a type:
//   b bool   c C 8-bit   w W 16-bit   i I 32-bit   l L 64-bit (lower case: signed)   f d floats
//   s string   r raw bytes   m dynamic   o object   v void   _ none   X unknown   * pointer
//   [T] list   {KV} map   (T...) tuple   +T optional   #T varargs   ~T keyword arguments
// and <...>, balanced, may follow any of them: the name of a struct and of its fields.

/// The deepest nesting of a type, and of a value, that is accepted.
constexpr int kMaxNesting = 64;

/// The longest text that is accepted as a signature.
constexpr std::size_t kMaxSignature = 64U << 10U;

/// A parsed signature: one type and the types it is made of. Immutable.
class Signature {
 public:
  /// The one type `text` names, or nothing if it is not exactly one well-formed type.
  static std::optional<Signature> parse(std::string_view text);

  /// The same for a text of our own. Aborts if it is not well-formed.
  static Signature of(std::string_view text);

  char kind() const { return kind_; }
  bool is(char kind) const { return kind_ == kind; }
  const std::vector<Signature>& children() const { return children_; }

  /// What stands between < and >, without them.
  const std::string& annotation() const { return annotation_; }

  /// The signature as text, annotations included.
  std::string text() const;

  /// The type in words, as NaoQi's error texts name it: List<String>, Int32, ...
  std::string words() const;

  /// True if both name the same bytes: annotations may differ.
  bool hasLayoutOf(const Signature& other) const;

 private:
  friend class SignatureParser;

  char kind_ = 'v';
  std::vector<Signature> children_;
  std::string annotation_;
};

}  // namespace nao::rpc
