#pragma once

#include "runtime/database.h"
#include "runtime/input.h"
#include "runtime/plain_structs.h"

namespace nao::runtime {

/// What tells a recording from other SQLite files, and its form from older ones.
inline constexpr int kRecordingId = 0x4e614f52;  // "NaOR", SQLite's application_id
inline constexpr int kRecordingVersion = 1;      // SQLite's user_version

/// Closes bytes with a sum, so that broken ones are not misread.
void seal(Bytes& bytes);
/// @throws InputError for bytes that are not as they were sealed.
void unseal(Bytes& bytes);

template <class T>
Bytes toBytes(T value) {
  Bytes bytes;
  Archive archive = Archive::saving(bytes);
  archiveValue(archive, value);
  seal(bytes);
  return bytes;
}

/// @throws InputError for what is broken or no such value.
template <class T>
T fromBytes(Bytes bytes) {
  unseal(bytes);
  T value{};
  Archive archive = Archive::loading(bytes);
  archiveValue(archive, value);
  return value;
}

/// Turns inputs into bytes and back, in their order. What comes often is written short: commands of
/// bodies as what changed since the robot's last, lights by number once their name has been
/// written.
class InputCodec {
 public:
  /// Adds an input to `bytes`.
  void encode(const Input& input, Bytes& bytes);
  /// The contents of sealed bytes, all of one robot. @throws InputError for what is broken or no
  /// inputs.
  std::vector<Input::Content> decode(Bytes bytes, std::size_t robot);

 private:
  void archive(Archive& archive, std::size_t robot, Input::Content& content);
  void archiveBody(Archive& archive, std::size_t robot, BodyCommand& command);
  void archiveLights(Archive& archive, LedOrder& order);

  std::vector<BodyCommand> last_;    // by robot
  std::vector<std::string> lights_;  // by number
};

}  // namespace nao::runtime
