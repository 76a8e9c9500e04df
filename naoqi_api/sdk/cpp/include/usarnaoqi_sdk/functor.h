#pragma once

#include <functional>
#include <string>
#include <vector>

#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/cast.h>

namespace AL {
namespace detail {

/// A method of a module as others call it.
struct Functor {
  std::string parameters;  // signature, a tuple
  std::string returns;
  std::function<ALValue(const std::vector<ALValue>&)> call;
};

template <int...>
struct Indices {};
template <int kCount, int... kRest>
struct IndicesUpTo : IndicesUpTo<kCount - 1, kCount - 1, kRest...> {};
template <int... kAll>
struct IndicesUpTo<0, kAll...> {
  typedef Indices<kAll...> type;
};

template <class R>
struct Invoke {
  template <class C, class M, class... P, int... kAt>
  static ALValue on(C* object, M method, const std::vector<ALValue>& values, Indices<kAt...>) {
    static_cast<void>(values);
    return ALValue((object->*method)(Cast<P>::of(values[kAt])...));
  }
};
template <>
struct Invoke<void> {
  template <class C, class M, class... P, int... kAt>
  static ALValue on(C* object, M method, const std::vector<ALValue>& values, Indices<kAt...>) {
    static_cast<void>(values);
    (object->*method)(Cast<P>::of(values[kAt])...);
    return ALValue();
  }
};

inline std::string tupleOf(const std::vector<std::string>& types) {
  std::string text = "(";
  for (std::size_t i = 0; i < types.size(); ++i) text += types[i];
  return text + ")";
}

template <class C, class M, class R, class... P>
Functor makeFunctorOf(C* object, M method) {
  Functor functor;
  functor.parameters = tupleOf(std::vector<std::string>{WireType<P>::name()...});
  functor.returns = WireType<R>::name();
  functor.call = [object, method](const std::vector<ALValue>& values) {
    return Invoke<R>::template on<C, M, P...>(object, method, values,
                                              typename IndicesUpTo<sizeof...(P)>::type());
  };
  return functor;
}

template <class C, class B, class R, class... P>
Functor makeFunctor(C* object, R (B::*method)(P...)) {
  return makeFunctorOf<C, R (B::*)(P...), typename Bare<R>::type, typename Bare<P>::type...>(
      object, method);
}
template <class C, class B, class R, class... P>
Functor makeFunctor(C* object, R (B::*method)(P...) const) {
  return makeFunctorOf<C, R (B::*)(P...) const, typename Bare<R>::type, typename Bare<P>::type...>(
      object, method);
}

}  // namespace detail
}  // namespace AL
