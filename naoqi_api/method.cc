#include "naoqi_api/method.h"

#include "naoqi_api/call_error.h"
#include "naoqi_api/fits.h"

namespace nao::rpc {
namespace {

// The types of a value once its dynamics are looked into: (mm) of two texts is (String,String).
std::string wordsOf(const Value& value) {
  const Value& bare = value.bare();
  if (const auto* tuple = bare.find<Value::Tuple>()) {
    std::string words;
    for (const Value& item : tuple->items) words += (words.empty() ? "" : ",") + wordsOf(item);
    return "(" + words + ")";
  }
  const auto type = Signature::parse(bare.signature());
  return type ? type->words() : "Unknown";
}

// libqi counts and lists the object itself as argument 0.
std::string withSelf(const Signature& parameters) {
  std::string words = "(Unknown";
  for (const Signature& parameter : parameters.children()) words += "," + parameter.words();
  return words + ")";
}

std::vector<Value> convertArguments(const Signature& parameters, const std::vector<Value>& given) {
  if (parameters.is('m')) return given;  // a client's method that takes anything
  const auto& types = parameters.children();
  if (given.size() != types.size()) {
    throw CallError("Argument count mismatch, expected " + std::to_string(types.size() + 1) +
                    ", got " + std::to_string(given.size() + 1));
  }
  std::vector<Value> converted;
  for (std::size_t i = 0; i < types.size(); ++i) {
    auto fitting = convert(given[i], types[i], Bend::Declared);
    if (!fitting) {
      throw CallError("Call argument number " + std::to_string(i + 1) +
                      " conversion failure from " + wordsOf(given[i]) + " to " + types[i].words() +
                      ". Function signature: " + withSelf(parameters) + ".");
    }
    converted.push_back(*std::move(fitting));
  }
  return converted;
}

}  // namespace

namespace {

bool allFit(const Signature& parameters, const std::vector<Value>& given) {
  const auto& types = parameters.children();
  if (given.size() != types.size()) return false;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (!fits(given[i], types[i])) return false;
  }
  return true;
}

}  // namespace

Pending<Value> Method::invoke(const Caller& caller,
                              const std::vector<Value>& arguments_given) const {
  try {
    if (allFit(parameters, arguments_given)) return call(caller, arguments_given);
    return call(caller, convertArguments(parameters, arguments_given));
  } catch (const CallError& error) {
    Pending<Value> failed;
    failed.fail(error.what());
    return failed;
  }
}

}  // namespace nao::rpc
