#pragma once

#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>

namespace AL {

/// What NAOqi 1.x calls a shared pointer. A function of the one kind takes and gives the other.
template <class T>
using ALPtr = boost::shared_ptr<T>;

template <class T>
using ALWeakPtr = boost::weak_ptr<T>;

}  // namespace AL
