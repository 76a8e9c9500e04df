#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "naoqi_api/convert.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/session.h"

namespace nao::rpc {

class Service;
class Tasks;

/// The name and meaning of one argument, as shown to clients.
struct Argument {
  std::string name;
  std::string meaning;
};

/// Who calls. A method that needs to know takes `const Caller&` as its first parameter; clients do
/// not see that parameter. `session` is null for a call from inside the program.
struct Caller {
  std::shared_ptr<Session> session;
  Service* service = nullptr;  // the one that was called
  Tasks* tasks = nullptr;      // what .post started

  std::uint64_t id() const { return session ? session->id() : 0; }
};

/// Takes the arguments, already converted to the declared types.
using Handler = std::function<Pending<Value>(const Caller&, const std::vector<Value>& arguments)>;

/// What a method does, compared with a robot's.
enum class Answer {
  Done,          // as on the robot, in the simulated world
  Simplified,    // keeps what it is told and takes its time; what would come of it is not simulated
  NotSimulated,  // an error that says so
};

/// A method as clients see it, and the code that serves it.
struct Method {
  std::uint32_t uid = 0;
  std::string name;
  std::string parameters_signature;  // e.g. "(mmf)"
  std::string return_signature;      // e.g. "v"
  std::string meaning;
  std::vector<Argument> arguments;
  std::string return_meaning;
  Answer answer = Answer::Done;
  Handler call;
  Signature parameters = Signature::of("()");  // of the texts above; Service::add() sets them
  Signature returns = Signature::of("v");

  /// Another type of result: as text and read.
  void setReturns(std::string signature) {
    returns = Signature::of(signature);
    return_signature = std::move(signature);
  }

  /// Converts the arguments as a libqi server would and runs the method. Every CallError becomes
  /// a failed result; nothing is thrown.
  Pending<Value> invoke(const Caller& caller, const std::vector<Value>& arguments_given) const;
};

namespace detail {

template <class... P>
struct Parameters {
  static constexpr bool kTakesCaller = false;
  using Values = std::tuple<std::decay_t<P>...>;

  /// What a handler is called with; a Value is lent, not copied.
  static auto read(const std::vector<Value>& arguments) {
    return readEach(arguments, std::index_sequence_for<P...>());
  }

 private:
  template <std::size_t... kIndex>
  static auto readEach([[maybe_unused]] const std::vector<Value>& arguments,
                       std::index_sequence<kIndex...> /*all*/) {
    using Type = std::tuple<decltype(ValueType<std::decay_t<P>>::read(arguments[kIndex]))...>;
    return Type(ValueType<std::decay_t<P>>::read(arguments[kIndex])...);
  }
};
template <class... P>
struct Parameters<const Caller&, P...> : Parameters<P...> {
  static constexpr bool kTakesCaller = true;
};

template <std::size_t kDocumented, class... P>
constexpr void checkDocumented() {
  static_assert(kDocumented == std::tuple_size_v<typename Parameters<P...>::Values>,
                "one Argument{} per parameter, please");
}

/// Runs `call`, which returns an R, and gives its result the one form that wires know.
template <class R, class F>
Pending<Value> complete(const F& call) {
  Pending<Value> result;
  if constexpr (std::is_void_v<R>) {
    call();
    result.resolve();
  } else if constexpr (kIsPending<R>) {
    const R pending = call();
    pending.whenDone([result](const auto& outcome) {
      using Stored = typename R::Stored;
      if (outcome.isCanceled()) return result.cancelNow();
      if (outcome.error) return result.fail(*outcome.error);
      if constexpr (std::is_same_v<Stored, std::monostate>) {
        result.resolve();
      } else {
        result.resolve(toValue<Stored>(*outcome.value));
      }
    });
    if (!result.isDone()) result.cancelsWith(pending);
  } else {
    result.resolve(toValue<R>(call()));
  }
  return result;
}

/// The handler of a callable R(P...).
template <class R, class... P, class F>
Handler handlerOf(F function) {
  using Shape = Parameters<P...>;
  return [function](const Caller& caller, const std::vector<Value>& arguments) {
    const auto values = Shape::read(arguments);
    return complete<R>([&]() -> R {
      return std::apply(
          [&](const auto&... value) -> R {
            if constexpr (Shape::kTakesCaller) {
              return function(caller, value...);
            } else {
              (void)caller;
              return function(value...);
            }
          },
          values);
    });
  };
}

}  // namespace detail
}  // namespace nao::rpc
