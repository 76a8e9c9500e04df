#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "core/archive.h"
#include "core/check.h"
#include "core/joint.h"

namespace nao {

/// How many members a plain struct has, for archiveValue(): one line a struct, said once, where it
/// is archived. A wrong number does not compile, so that no member is forgotten. Structs without
/// members need no line.
template <class T>
inline constexpr std::size_t kMembers = 0;

/// References to all members of a plain struct, in their order.
template <class T>
auto tieMembers(T& object);

/// Lists any plain value in an archive: numbers, texts, lists, maps, optionals, shared constants,
/// variants, and structs of these by their members. Every struct is written with its number of
/// members and size, so that one that has had other members since is not misread.
/// @throws InputError when that is so.
template <class T>
void archiveValue(Archive& archive, T& value);

namespace members_detail {

template <class T, template <class...> class Template>
inline constexpr bool kIs = false;
template <template <class...> class Template, class... Args>
inline constexpr bool kIs<Template<Args...>, Template> = true;

template <class T>
inline constexpr bool kIsArray = false;
template <class T, std::size_t n>
inline constexpr bool kIsArray<std::array<T, n>> = true;
template <class T>
inline constexpr bool kIsMatrix = false;
template <class S, int r, int c, int o, int mr, int mc>
inline constexpr bool kIsMatrix<Eigen::Matrix<S, r, c, o, mr, mc>> = true;
template <class T>
inline constexpr bool kIsJointArray = false;
template <class T>
inline constexpr bool kIsJointArray<JointArray<T>> = true;
template <class T>
inline constexpr bool kIsTime = false;
template <class Rep, class Period>
inline constexpr bool kIsTime<std::chrono::duration<Rep, Period>> = true;
template <class Clock, class D>
inline constexpr bool kIsTime<std::chrono::time_point<Clock, D>> = true;

[[noreturn]] inline void reject() {
  throw InputError("it was written by another version of this program");
}

// A small number that must be as expected when read.
inline void tag(Archive& archive, std::uint8_t expected) {
  std::uint8_t found = expected;
  archive.value(found);
  if (found != expected) reject();
}

// Whether there is one.
inline bool presence(Archive& archive, bool is_there) {
  auto flag = static_cast<std::uint8_t>(is_there);
  archive.value(flag);
  return flag != 0;
}

template <class K, class V>
void archiveMap(Archive& archive, std::map<K, V>& map) {
  std::vector<std::pair<K, V>> items(map.begin(), map.end());
  archiveValue(archive, items);
  if (archive.mode() == Archive::Mode::Load) map = {items.begin(), items.end()};
}

template <class T>
void archivePointer(Archive& archive, std::shared_ptr<const T>& pointer) {
  if (!presence(archive, pointer != nullptr)) return pointer.reset();
  T object = pointer ? *pointer : T{};
  archiveValue(archive, object);
  if (archive.mode() == Archive::Mode::Load) pointer = std::make_shared<const T>(std::move(object));
}

template <class Variant, std::size_t i = 0>
void emplaceAlternative(Variant& value, std::size_t index) {
  if constexpr (i == std::variant_size_v<Variant>) {
    reject();
  } else {
    if (i != index) return emplaceAlternative<Variant, i + 1>(value, index);
    value.template emplace<i>();
  }
}

template <class Variant>
void archiveVariant(Archive& archive, Variant& value) {
  auto index = static_cast<std::uint16_t>(value.index());
  archive.value(index);
  if (archive.mode() == Archive::Mode::Load) emplaceAlternative(value, index);
  std::visit([&archive](auto& alternative) { archiveValue(archive, alternative); }, value);
}

// With the places that no joint uses: they are part of hashes.
template <class T>
void archiveJoints(Archive& archive, JointArray<T>& joints) {
  auto size = static_cast<std::uint8_t>(joints.size());
  archive.value(size);
  if (size > kMaxJoints) reject();
  if (size != joints.size()) joints = JointArray<T>(size);
  for (std::size_t i = 0; i < kMaxJoints; ++i) archiveValue(archive, joints[i]);
}

template <class T>
void archiveStruct(Archive& archive, T& object) {
  tag(archive, static_cast<std::uint8_t>(kMembers<T>));
  tag(archive, static_cast<std::uint8_t>(sizeof(T) / 4));
  const auto one = [&archive](auto&... member) { (archiveValue(archive, member), ...); };
  std::apply(one, tieMembers(object));
}

}  // namespace members_detail

template <class T>
void archiveValue(Archive& archive, T& value) {
  using namespace members_detail;
  if constexpr (std::is_same_v<T, bool>) {
    value = presence(archive, value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || kIsTime<T>) {
    archive.value(value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    std::vector<char> letters(value.begin(), value.end());
    archive.list(letters);
    value.assign(letters.begin(), letters.end());
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    archive.numbers(value.matrix());
  } else if constexpr (kIsMatrix<T>) {
    archive.numbers(value);
  } else if constexpr (kIs<T, std::vector>) {
    archive.each(value, [&archive](auto& item) { archiveValue(archive, item); });
  } else if constexpr (kIsArray<T>) {
    for (auto& item : value) archiveValue(archive, item);
  } else if constexpr (kIsJointArray<T>) {
    archiveJoints(archive, value);
  } else if constexpr (kIs<T, std::pair>) {
    archiveValue(archive, value.first);
    archiveValue(archive, value.second);
  } else if constexpr (kIs<T, std::map>) {
    archiveMap(archive, value);
  } else if constexpr (kIs<T, std::optional>) {
    if (!presence(archive, value.has_value())) return value.reset();
    if (!value) value.emplace();
    archiveValue(archive, *value);
  } else if constexpr (kIs<T, std::shared_ptr>) {
    archivePointer(archive, value);
  } else if constexpr (kIs<T, std::variant>) {
    archiveVariant(archive, value);
  } else {
    archiveStruct(archive, value);
  }
}

template <class T>
auto tieMembers(T& object) {
  constexpr std::size_t n = kMembers<T>;
  if constexpr (n == 0) {
    static_assert(std::is_empty_v<T>, "say in kMembers how many members it has");
    return std::tuple<>();
  } else if constexpr (n == 1) {
    auto& [a] = object;
    return std::tie(a);
  } else if constexpr (n == 2) {
    auto& [a, b] = object;
    return std::tie(a, b);
  } else if constexpr (n == 3) {
    auto& [a, b, c] = object;
    return std::tie(a, b, c);
  } else if constexpr (n == 4) {
    auto& [a, b, c, d] = object;
    return std::tie(a, b, c, d);
  } else if constexpr (n == 5) {
    auto& [a, b, c, d, e] = object;
    return std::tie(a, b, c, d, e);
  } else if constexpr (n == 6) {
    auto& [a, b, c, d, e, f] = object;
    return std::tie(a, b, c, d, e, f);
  } else if constexpr (n == 7) {
    auto& [a, b, c, d, e, f, g] = object;
    return std::tie(a, b, c, d, e, f, g);
  } else if constexpr (n == 8) {
    auto& [a, b, c, d, e, f, g, h] = object;
    return std::tie(a, b, c, d, e, f, g, h);
  } else if constexpr (n == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = object;
    return std::tie(a, b, c, d, e, f, g, h, i);
  } else if constexpr (n == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = object;
    return std::tie(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (n == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = object;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (n == 12) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = object;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
  } else if constexpr (n == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = object;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else {
    static_assert(n < 14, "so many members want a tieMembers() of their own");
  }
}

}  // namespace nao
