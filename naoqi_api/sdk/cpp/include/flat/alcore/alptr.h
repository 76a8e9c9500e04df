#pragma once

#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>

namespace AL {

/// What NAOqi 1.x calls a shared pointer.
template <class T>
class ALPtr : public boost::shared_ptr<T> {
 public:
  ALPtr() {}
  explicit ALPtr(T* object) : boost::shared_ptr<T>(object) {}
  template <class U>
  ALPtr(const boost::shared_ptr<U>& other) : boost::shared_ptr<T>(other) {}
};

template <class T>
class ALWeakPtr : public boost::weak_ptr<T> {
 public:
  ALWeakPtr() {}
  template <class U>
  ALWeakPtr(const boost::shared_ptr<U>& other) : boost::weak_ptr<T>(other) {}
};

}  // namespace AL
