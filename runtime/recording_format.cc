#include "runtime/recording_format.h"

#include <algorithm>
#include <cstring>

#include "core/overloaded.h"

namespace nao::runtime {
namespace {

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Which of a command's numbers are written at all, and which of these as a float without loss.
struct Forms {
  std::uint64_t changed = 0;
  std::uint64_t single = 0;
};

Forms formsOf(const JointArray<double>& before, const JointArray<double>& now) {
  Forms forms;
  for (std::size_t i = 0; i < kMaxJoints; ++i) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (!sameBits(before[i], now[i])) forms.changed |= bit;
    if (sameBits(static_cast<float>(now[i]), now[i])) forms.single |= bit;
  }
  forms.single &= forms.changed;
  return forms;
}

void archiveAsFloat(Archive& archive, double& number) {
  auto single = static_cast<float>(number);
  archive.value(single);
  number = single;
}

// All places of the array, as archiveValue() has them.
void archiveNumbers(Archive& archive, const JointArray<double>& before, JointArray<double>& now) {
  Forms forms = formsOf(before, now);
  auto size = static_cast<std::uint8_t>(now.size());
  archive.value(size);
  archive.value(forms);
  if (size > kMaxJoints) throw InputError("it commands too many joints");
  if (now.size() != size) now = JointArray<double>(size);
  for (std::size_t i = 0; i < kMaxJoints; ++i) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (!(forms.changed & bit)) {
      now[i] = before[i];
    } else if (forms.single & bit) {
      archiveAsFloat(archive, now[i]);
    } else {
      archive.value(now[i]);
    }
  }
}

std::uint64_t sumOf(const unsigned char* bytes, std::size_t count) {
  Archive hash = Archive::hashing();
  for (std::size_t i = 0; i < count; ++i) {
    unsigned char byte = bytes[i];
    hash.value(byte);
  }
  return hash.hash();
}

}  // namespace

void seal(Bytes& bytes) {
  std::uint64_t sum = sumOf(bytes.data(), bytes.size());
  Archive::saving(bytes).value(sum);
}

void unseal(Bytes& bytes) {
  std::uint64_t sum = 0;
  if (bytes.size() < sizeof sum) throw InputError("a part is broken");
  const std::size_t size = bytes.size() - sizeof sum;
  std::memcpy(&sum, bytes.data() + size, sizeof sum);
  if (sum != sumOf(bytes.data(), size)) throw InputError("a part is broken");
  bytes.resize(size);
}

void InputCodec::archiveBody(Archive& archive, std::size_t robot, BodyCommand& command) {
  if (last_.size() <= robot) last_.resize(robot + 1);
  BodyCommand& last = last_[robot];
  archive.value(command.number);
  archiveNumbers(archive, last.angle, command.angle);
  archiveNumbers(archive, last.stiffness, command.stiffness);
  last = command;
}

void InputCodec::archiveLights(Archive& archive, LedOrder& order) {
  const auto known = std::find(lights_.begin(), lights_.end(), order.leds);
  auto number = static_cast<std::uint16_t>(known - lights_.begin());
  archive.value(number);
  if (number < lights_.size()) {
    order.leds = lights_[number];
  } else {
    archiveValue(archive, order.leds);
    if (lights_.size() < UINT16_MAX) lights_.push_back(order.leds);
  }
  archive.value(order.brightness);
}

void InputCodec::archive(Archive& archive, std::size_t robot, Input::Content& content) {
  auto kind = static_cast<std::uint8_t>(content.index());
  archive.value(kind);
  if (kind != content.index()) members_detail::emplaceAlternative(content, kind);
  std::visit(Overloaded{[&](BodyCommand& command) { archiveBody(archive, robot, command); },
                        [&](LedOrder& order) { archiveLights(archive, order); },
                        [&](auto& other) { archiveValue(archive, other); }},
             content);
}

void InputCodec::encode(const Input& input, Bytes& bytes) {
  Archive saving = Archive::saving(bytes);
  Input copy = input;
  archive(saving, input.robot, copy.content);
}

std::vector<Input::Content> InputCodec::decode(Bytes bytes, std::size_t robot) {
  unseal(bytes);
  Archive loading = Archive::loading(bytes);
  std::vector<Input::Content> contents;
  while (!loading.atEnd()) archive(loading, robot, contents.emplace_back());
  return contents;
}

}  // namespace nao::runtime
