#include "runtime/input.h"

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <typeinfo>

#include "runtime/plain_structs.h"

namespace nao::runtime {
namespace {

// The name of the type without its namespaces.
std::string shortName(const std::type_info& type) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr), &std::free);
  const std::string whole = name ? name.get() : type.name();
  return whole.substr(whole.rfind(':') + 1);
}

}  // namespace

std::string nameOf(const Input::Content& content) {
  const auto name = [](const auto& one) { return shortName(typeid(one)); };
  if (const auto* request = std::get_if<motion::MotionRequest>(&content)) {
    return std::visit(name, request->action);
  }
  if (const auto* request = std::get_if<WorldRequest>(&content)) return std::visit(name, *request);
  return std::visit(name, content);
}

void archiveContent(Archive& archive, Input::Content& content) { archiveValue(archive, content); }

void addTo(Archive& hash, const Input& input) {
  Input copy = input;
  if (auto* request = std::get_if<motion::MotionRequest>(&copy.content)) request->id = 0;
  if (auto* command = std::get_if<BodyCommand>(&copy.content)) command->number = 0;
  archiveValue(hash, copy.time);
  archiveValue(hash, copy.robot);
  archiveContent(hash, copy.content);
}

}  // namespace nao::runtime
