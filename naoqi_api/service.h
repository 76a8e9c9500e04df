#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/method.h"
#include "naoqi_api/monitor.h"
#include "naoqi_api/signal.h"

namespace nao::rpc {

/// A signal as clients see it.
struct SignalMember {
  std::uint32_t uid = 0;
  std::string name;
  Emitter emitter;
};

/// A property as clients see it; its emitter is also a signal with the same uid.
struct PropertyMember {
  std::uint32_t uid = 0;
  std::string name;
  std::string signature;
  Emitter emitter;
  std::function<Pending<Value>()> get;
  std::function<Pending<void>(const Value&)> set;  // of exactly that signature
};

/// What a service, or an object that a service hands out, offers. Built once from typed C++ member
/// functions: signatures, metaobject, documentation and decoding all come from the one declaration.
/// NaoQi's own modules start from alModule() (naoqi_api/al_module.h), which adds ids 100 to 112.
class Service {
 public:
  static constexpr std::uint32_t kFirstUid = 100;  // below: what every qi object has

  Service(std::string name, std::string meaning);

  /// Adds `function` of `self` under `name`. There must be one Argument per parameter.
  template <class C, class R, class... P, class... Arguments>
  Service& method(std::string name, C* self, R (C::*function)(P...), std::string meaning,
                  Arguments... arguments) {
    detail::checkDocumented<sizeof...(Arguments), P...>();
    return addMethod<R, P...>(
        std::move(name),
        [self, function](const auto&... value) -> R { return (self->*function)(value...); },
        std::move(meaning), {Argument(std::move(arguments))...});
  }
  template <class C, class R, class... P, class... Arguments>
  Service& method(std::string name, const C* self, R (C::*function)(P...) const,
                  std::string meaning, Arguments... arguments) {
    detail::checkDocumented<sizeof...(Arguments), P...>();
    return addMethod<R, P...>(
        std::move(name),
        [self, function](const auto&... value) -> R { return (self->*function)(value...); },
        std::move(meaning), {Argument(std::move(arguments))...});
  }
  /// The same for a callable, given as a std::function so that its types are known.
  template <class R, class... P, class... Arguments>
  Service& method(std::string name, std::function<R(P...)> function, std::string meaning,
                  Arguments... arguments) {
    detail::checkDocumented<sizeof...(Arguments), P...>();
    return addMethod<R, P...>(std::move(name), std::move(function), std::move(meaning),
                              {Argument(std::move(arguments))...});
  }

  template <class... T>
  Service& signal(std::string name, const Signal<T...>& signal) {
    return addSignal(std::move(name), signal.emitter());
  }
  /// A signal with a signature such as "(m)"; emit it with emit(name, {...}).
  Service& signal(std::string name, std::string signature);

  template <class T>
  Service& property(std::string name, const Property<T>& property) {
    return addProperty({0, std::move(name), signatureOf<T>(), property.emitter(),
                        [property] { return Pending<Value>::done(toValue(property.get())); },
                        [property](const Value& value) {
                          property.set(ValueType<T>::read(value));
                          return Pending<void>::done();
                        }});
  }

  /// Gives the member declared last this uid instead of the next free one. A member that had got
  /// it by counting moves on to the next free one.
  Service& at(std::uint32_t uid);

  /// Overrides the signature of what the method declared last returns; it must return a Value.
  Service& returning(std::string signature, std::string meaning = {});

  /// Says what the method declared last does; Done if it is not said.
  Service& answering(Answer answer);
  /// The same for all methods declared so far that are the service's own.
  Service& allAnswering(Answer answer);

  /// Hands every method to `change`, before any client knows of it.
  template <class Change>
  void change(const Change& change) {
    for (auto& [uid, method] : methods_) change(method);
  }

  /// Takes away the methods of these names, before any client knows of them.
  void removeMethods(const std::set<std::string>& names);

  /// Members that follow count from this uid.
  Service& startAt(std::uint32_t uid);

  /// Keeps `implementation` alive as long as this service: for objects handed out by value.
  Service& owning(std::shared_ptr<void> implementation);

  /// Untyped, for what the templates can not say.
  Service& add(Method method);
  Service& addSignal(std::string name, Emitter emitter);
  Service& addProperty(PropertyMember property);

  /// Takes over members as they are, uids and signatures included: what a client offers. The
  /// method's name and signature may be there already; its uid must not.
  void insert(Method method);
  void insert(SignalMember signal);
  void insert(PropertyMember property);

  const std::string& name() const { return name_; }
  const std::string& meaning() const { return meaning_; }
  const std::map<std::uint32_t, Method>& methods() const { return methods_; }
  const std::map<std::uint32_t, SignalMember>& signals() const { return signals_; }
  const std::map<std::uint32_t, PropertyMember>& properties() const { return properties_; }

  const Method* findMethod(std::uint32_t uid) const;
  /// The overload with as many arguments that fits these best, else the first with as many.
  const Method* findMethod(std::string_view name, const std::vector<Value>& arguments) const;
  const Emitter* findSignal(std::uint32_t uid) const;  // of a signal or a property
  const Emitter* findSignal(std::string_view name) const;
  const PropertyMember* findProperty(std::uint32_t uid) const;
  const PropertyMember* findProperty(std::string_view name) const;

  /// Calls by name as a client in the same program would: an overload is chosen by the number of
  /// its arguments, then by which one they convert to. For pCall, msgpack and JSON wires, tests.
  Pending<Value> call(std::string_view name, const std::vector<Value>& arguments,
                      Caller caller = {});

  /// What clients watch this object with; copies of the service share it.
  Monitor& monitor() { return *monitor_; }

  /// Tells the listeners of the signal of that name.
  void emit(std::string_view signal, const std::vector<Value>& arguments) const;

 private:
  template <class R, class... P, class F>
  Service& addMethod(std::string name, F function, std::string meaning,
                     std::vector<Argument> arguments) {
    using Values = typename detail::Parameters<P...>::Values;
    Method method;
    method.name = std::move(name);
    method.parameters_signature = signatureOf<Values>();
    method.return_signature = signatureOf<R>();
    method.meaning = std::move(meaning);
    method.arguments = std::move(arguments);
    method.call = detail::handlerOf<R, P...>(std::move(function));
    return add(std::move(method));
  }

  std::uint32_t takeUid();
  void moveMember(std::uint32_t from, std::uint32_t to);
  bool isFree(std::uint32_t uid) const;

  std::string name_;
  std::string meaning_;
  std::map<std::uint32_t, Method> methods_;
  std::map<std::uint32_t, SignalMember> signals_;
  std::map<std::uint32_t, PropertyMember> properties_;
  std::vector<std::shared_ptr<void>> owned_;
  std::shared_ptr<Monitor> monitor_ = std::make_shared<Monitor>();
  std::uint32_t next_uid_ = kFirstUid;
  std::uint32_t last_uid_ = 0;
  std::set<std::uint32_t> given_uids_;  // by at()
};

}  // namespace nao::rpc
