#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "naoqi_api/value.h"

namespace nao::services {

/// A text file below the data directory that keeps what clients say, to be read by people too:
///   {"format": "usarnaoqi <kind>", "version": 1}
///   {"<name>": <JSON value>, ...}                    one such object a line
/// I/O thread.
class KeptLines {
 public:
  /// An object of the file: names and values.
  using Line = std::vector<std::pair<std::string, rpc::Value>>;

  /// @param data_dir empty: there is none, read() finds nothing and write() throws
  /// @param name of the file, below `data_dir`
  KeptLines(std::filesystem::path data_dir, std::string name, std::string kind);

  bool hasPlace() const { return !data_dir_.empty(); }

  /// Nothing if there is no such file. Every line has the values `wanted`, and perhaps more.
  /// @throws CallError naming file and line
  std::optional<std::vector<Line>> read(const std::vector<std::string>& wanted) const;

  /// The file before stays until the new one is complete.
  /// @throws CallError if it can not be written, or a value is none that JSON has
  void write(const std::vector<Line>& lines) const;

  /// Renames a file that can not be read, so that the next write() does not end it: its new name,
  /// or the old one if it can not be renamed.
  std::string putAside() const;

  /// @throws CallError unless a line can be written and read again.
  static void check(const Line& line);
  static const rpc::Value* find(const Line& line, const std::string& name);

 private:
  std::filesystem::path data_dir_;
  std::string name_;
  std::string kind_;
};

}  // namespace nao::services
