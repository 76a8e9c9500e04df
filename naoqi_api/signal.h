#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/convert.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// What a signal tells its listeners: the arguments, and what the first of them made of these for
/// all others, so that an event is encoded once however many clients hear of it.
class Emission {
 public:
  /// `arguments` outlive it.
  explicit Emission(const std::vector<Value>& arguments) : arguments_(arguments) {}
  Emission(const Emission&) = delete;
  Emission& operator=(const Emission&) = delete;

  const std::vector<Value>& arguments() const { return arguments_; }
  operator const std::vector<Value>&() const { return arguments_; }  // NOLINT: what most need

  /// What make() returned at the first call with this `form`, such as a signature; null if it made
  /// nothing then. It may depend on the form and the arguments alone.
  template <class Make>
  const Bytes* encoded(const std::string& form, const Make& make) const {
    if (form_ != form) {
      bytes_ = make();
      form_ = form;
    }
    return bytes_ ? &*bytes_ : nullptr;
  }

 private:
  const std::vector<Value>& arguments_;
  mutable std::optional<std::string> form_;
  mutable std::optional<Bytes> bytes_;
};

/// The untyped core of a signal: who listens, and how to tell them. A handle: copies share the
/// listeners. I/O thread only.
class Emitter {
 public:
  using Listener = std::function<void(const Emission&)>;  // or of the arguments

  /// `signature` is a tuple such as "(is)"; of what a client offers also a list or "m".
  explicit Emitter(std::string signature);

  const std::string& signature() const { return state_->signature; }

  /// Tells every listener, in the order they came. The arguments must fit the signature.
  void emit(const std::vector<Value>& arguments) const { pass(Emission(arguments)); }

  /// The same for what another signal of the same signature has emitted.
  void pass(const Emission& emission) const;

  /// Returns the number to disconnect with.
  std::uint64_t connect(Listener listener) const;
  void disconnect(std::uint64_t link) const;
  std::size_t listenerCount() const { return state_->count; }

  /// Ends once whoever raises it knows that somebody listens: nothing raised after that is lost.
  /// Has ended unless that is a client that was asked just now; fails if the client refuses.
  Pending<void> heard() const;
  void setHeard(Pending<void> heard) const { state_->heard = std::move(heard); }

  /// The same emitter as long as somebody else keeps it; does not keep it itself.
  std::function<std::optional<Emitter>()> weak() const;

  /// `changed` is told the number of listeners whenever it changes.
  void onListeners(std::function<void(std::size_t)> changed) const;

 private:
  /// One who listens, or has gone: then it stays in its place until nobody is being told.
  struct Entry {
    std::uint64_t link = 0;
    bool is_gone = false;
    Listener listener;
  };
  struct State {
    std::string signature;
    std::deque<Entry> listeners;  // by link; where they are they stay while more come
    std::size_t count = 0;        // of those that have not gone
    int telling = 0;              // emissions under way
    bool left_meanwhile = false;  // some have
    std::uint64_t next_link = 1;
    std::function<void(std::size_t)> changed;
    std::optional<Pending<void>> heard;
  };
  /// An emission under way.
  class Telling {
   public:
    explicit Telling(State& state) : state_(state) { ++state_.telling; }
    Telling(const Telling&) = delete;
    Telling& operator=(const Telling&) = delete;
    ~Telling();

   private:
    State& state_;
  };
  explicit Emitter(std::shared_ptr<State> state) : state_(std::move(state)) {}
  void tellChange() const;
  static void forgetGone(State& state);

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
