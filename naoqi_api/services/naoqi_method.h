#pragma once

#include <functional>
#include <string>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// An error text in the shape NaoQi's modules give it, seen in its users' logs:
///   \tALMemory::getData\n\tData not found <key>
inline std::string naoqiError(const std::string& where, const std::string& what) {
  return "\t" + where + "\n\t" + what;
}

namespace detail {

/// `result` with its error text, should it end with one, in NaoQi's shape.
template <class T>
rpc::Pending<T> withNaoqiError(const rpc::Pending<T>& result, const std::string& where) {
  if (result.isDone() && !result.outcome()->error) return result;
  rpc::Pending<T> told;
  result.whenDone([told, where](const auto& outcome) {
    if (outcome.isCanceled()) return told.cancelNow();
    if (outcome.error) return told.fail(naoqiError(where, *outcome.error));
    told.resolve(*outcome.value);
  });
  told.cancelsWith(result);
  return told;
}
template <class T>
T withNaoqiError(T result, const std::string& /*where*/) {
  return result;
}

template <class R, class... P, class... Arguments>
rpc::Service& addGuarded(rpc::Service& service, const std::string& name,
                         std::function<R(P...)> function, std::string meaning,
                         Arguments... arguments) {
  const std::string where = service.name() + "::" + name;
  std::function<R(P...)> guarded = [function = std::move(function), where](P... value) -> R {
    try {
      if constexpr (std::is_void_v<R>) {
        function(value...);
      } else {
        return withNaoqiError(function(value...), where);
      }
    } catch (const rpc::CallError& error) {
      throw rpc::CallError(naoqiError(where, error.what()));
    }
  };
  return service.method(name, std::move(guarded), std::move(meaning), std::move(arguments)...);
}

}  // namespace detail

/// As Service::method, but errors name the method and come in NaoQi's shape.
template <class C, class R, class... P, class... Arguments>
rpc::Service& addMethod(rpc::Service& service, const std::string& name, C* self,
                        R (C::*function)(P...), std::string meaning, Arguments... arguments) {
  std::function<R(P...)> call = [self, function](P... value) -> R {
    return (self->*function)(value...);
  };
  return detail::addGuarded(service, name, std::move(call), std::move(meaning),
                            std::move(arguments)...);
}

/// The same for a lambda.
template <class F, class... Arguments>
rpc::Service& addFunction(rpc::Service& service, const std::string& name, F function,
                          std::string meaning, Arguments... arguments) {
  return detail::addGuarded(service, name, std::function(std::move(function)), std::move(meaning),
                            std::move(arguments)...);
}

}  // namespace nao::services
