#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/convert.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// The untyped core of a signal: who listens, and how to tell them. A handle: copies share the
/// listeners. I/O thread only.
class Emitter {
 public:
  using Listener = std::function<void(const std::vector<Value>& arguments)>;

  /// `signature` is a tuple such as "(is)".
  explicit Emitter(std::string signature);

  const std::string& signature() const { return state_->signature; }

  /// Tells every listener, in the order they came. The arguments must fit the signature.
  void emit(const std::vector<Value>& arguments) const;

  /// Returns the number to disconnect with.
  std::uint64_t connect(Listener listener) const;
  void disconnect(std::uint64_t link) const;
  std::size_t listenerCount() const { return state_->listeners.size(); }

  /// The same emitter as long as somebody else keeps it; does not keep it itself.
  std::function<std::optional<Emitter>()> weak() const;

  /// `changed` is told the number of listeners whenever it changes.
  void onListeners(std::function<void(std::size_t)> changed) const;

 private:
  struct State {
    std::string signature;
    std::map<std::uint64_t, Listener> listeners;
    std::uint64_t next_link = 1;
    std::function<void(std::size_t)> changed;
  };
  explicit Emitter(std::shared_ptr<State> state) : state_(std::move(state)) {}
  void tellChange() const;

  std::shared_ptr<State> state_;
};

/// A signal of a service, typed: Signal<int, std::string> tick; tick(42, "tick").
template <class... T>
class Signal {
 public:
  void operator()(const T&... arguments) const { emitter_.emit({toValue(arguments)...}); }
  const Emitter& emitter() const { return emitter_; }

 private:
  Emitter emitter_{"(" + (signatureOf<T>() + ... + std::string()) + ")"};
};

/// A value that clients read, set and watch. `onSet` may refuse by throwing CallError.
template <class T>
class Property {
 public:
  explicit Property(T value = {}) : state_(std::make_shared<State>(State{std::move(value), {}})) {}

  const T& get() const { return state_->value; }

  /// Sets and tells the listeners.
  void set(T value) const {
    if (state_->on_set) state_->on_set(value);
    state_->value = std::move(value);
    changed_(state_->value);
  }

  void onSet(std::function<void(const T&)> on_set) const { state_->on_set = std::move(on_set); }
  const Emitter& emitter() const { return changed_.emitter(); }

 private:
  struct State {
    T value;
    std::function<void(const T&)> on_set;
  };
  std::shared_ptr<State> state_;
  Signal<T> changed_;
};

}  // namespace nao::rpc
