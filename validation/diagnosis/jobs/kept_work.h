#pragma once

#include <functional>
#include <optional>
#include <string>

namespace nao::validation {

/// What a long work has finished so far, in a folder of its own: a file per unit, which is there
/// whole or not at all, so that a work that was cut off goes on where it stood. Any thread may keep
/// and find; who keeps the same unit as another keeps the same in it.
class KeptWork {
 public:
  enum class Found { Nothing, Same, Other };

  /// Keeps nothing.
  KeptWork() = default;
  /// Takes up what `folder` holds if it was kept under the same `key`: whatever decides what the
  /// units hold. Else it is emptied. @throws InputError if nothing can be written there.
  KeptWork(std::string folder, const std::string& key);

  bool keeps() const { return !folder_.empty(); }
  Found found() const { return found_; }

  std::optional<std::string> find(const std::string& unit) const;
  void keep(const std::string& unit, const std::string& content) const;
  /// The unit as it was kept, or as `work` makes it now.
  std::string remember(const std::string& unit, const std::function<std::string()>& work) const;

  /// The same folder for units whose names may be those of others: a part of the work with a name.
  KeptWork part(const std::string& name) const;

  /// The work is done: the folder goes.
  void discard() const;

 private:
  std::string fileOf(const std::string& unit) const;

  std::string folder_, part_;
  Found found_ = Found::Nothing;
};

}  // namespace nao::validation
