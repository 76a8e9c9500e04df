#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nao {

/// A YAML file as plain values: what Config looks into, so that only config_node.cc knows the
/// YAML library.
struct ConfigNode {
  enum class Kind { Empty, Scalar, List, Map };
  Kind kind = Kind::Empty;
  std::shared_ptr<const std::string> file;  // never null in a parsed node
  int line = 1;                             // from 1
  std::string text;                         // scalar
  std::vector<std::string> keys;            // map, in file order; keys[i] belongs to children[i]
  std::vector<ConfigNode> children;

  /// For a message: the scalar itself, or what kind of thing stands there.
  std::string described() const;
  /// The child at `key` of a map, or null.
  const ConfigNode* find(const std::string& key) const;
};

/// @throws InputError when the file can not be read, is not YAML or gives a key twice.
ConfigNode parseConfigFile(const std::string& file);

/// The whole of `text` as a finite number, written with a point in every locale.
std::optional<double> parseNumber(const std::string& text);

/// "file:line: sentence", the form of every complaint about a file.
std::string complaint(const std::string& file, int line, const std::string& sentence);
std::string complaint(const ConfigNode& node, const std::string& sentence);

}  // namespace nao
