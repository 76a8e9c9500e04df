#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace nao::rpc {

/// How a call ended: with a value, with an error text, or canceled (neither).
template <class T>
struct Outcome {
  std::optional<T> value;
  std::optional<std::string> error;

  bool isCanceled() const { return !value && !error; }
};

/// The result of a call that ends later, such as angleInterpolation(). A handle: copies share one
/// result. The service keeps a copy and resolves it once, the caller is told then, and no thread
/// waits. All of it happens on the I/O thread.
template <class T>
class Pending {
 public:
  using Stored = std::conditional_t<std::is_void_v<T>, std::monostate, T>;
  using Done = std::function<void(const Outcome<Stored>&)>;

  Pending() = default;

  /// A call that has ended already.
  static Pending done(Stored value = {}) {
    Pending pending;
    pending.resolve(std::move(value));
    return pending;
  }
  static Pending failed(std::string text) {
    Pending pending;
    pending.fail(std::move(text));
    return pending;
  }

  /// Ends the call with its value; Pending<void>: resolve(). Later ends are ignored.
  void resolve(Stored value = {}) const { end({std::move(value), {}}); }

  /// Ends the call with an error for the client.
  void fail(std::string text) const { end({{}, std::move(text)}); }

  /// Calls `done` with the outcome: now if it is already there, else when it comes.
  void whenDone(Done done) const {
    if (state_->outcome) {
      done(*state_->outcome);
    } else {
      state_->done.push_back(std::move(done));
    }
  }

  /// Makes the call one that can be canceled: `stop` is to end what was started. A call without
  /// it ignores a cancel and ends normally.
  void onCancel(std::function<void()> stop) const {
    if (!state_->outcome) state_->stop = std::move(stop);
  }

  /// For a call that only waits, so that a cancel has nothing to end: it can be canceled, and it
  /// is, should its client go. `forget` is called then.
  void onlyWaits(std::function<void()> forget = [] {}) const {
    if (state_->outcome) return;
    state_->stop = std::move(forget);
    state_->only_waits = true;
  }

  /// For a result that is made of another: canceled or abandoned with it.
  template <class U>
  void cancelsWith(const Pending<U>& source) const {
    if (!source.canBeCanceled()) return;
    onCancel(source.canceler());
    state_->only_waits = source.isOnlyWaiting();
  }

  /// Its client has gone. A call that only waits ends; what others have started goes on.
  void abandon() const {
    if (state_->only_waits) cancel();
  }

  /// Stops a call that can be canceled; it then counts as canceled unless `stop` ended it itself.
  void cancel() const {
    if (state_->outcome || !state_->stop) return;
    const auto state = state_;  // `stop` may drop the last other copy
    const auto stop = std::exchange(state->stop, {});
    stop();
    end({});
  }

  /// Ends the call as canceled, whether or not it can be stopped.
  void cancelNow() const { end({}); }

  /// cancel() as a function that does not keep the result alive.
  std::function<void()> canceler() const {
    return [weak = std::weak_ptr<State>(state_)] {
      if (auto state = weak.lock()) Pending(std::move(state)).cancel();
    };
  }

  bool isOnlyWaiting() const { return state_->only_waits; }
  bool canBeCanceled() const { return static_cast<bool>(state_->stop); }
  bool isDone() const { return state_->outcome.has_value(); }
  const std::optional<Outcome<Stored>>& outcome() const { return state_->outcome; }

 private:
  struct State {
    std::optional<Outcome<Stored>> outcome;
    std::vector<Done> done;
    std::function<void()> stop;
    bool only_waits = false;
  };

  explicit Pending(std::shared_ptr<State> state) : state_(std::move(state)) {}

  void end(Outcome<Stored> outcome) const {
    if (state_->outcome) return;
    const auto state = state_;  // a callback may drop the last other copy
    state->outcome = std::move(outcome);
    state->stop = {};
    const auto callbacks = std::exchange(state->done, {});
    for (const Done& done : callbacks) done(*state->outcome);
  }

  std::shared_ptr<State> state_ = std::make_shared<State>();
};

template <class T>
inline constexpr bool kIsPending = false;
template <class T>
inline constexpr bool kIsPending<Pending<T>> = true;

}  // namespace nao::rpc
