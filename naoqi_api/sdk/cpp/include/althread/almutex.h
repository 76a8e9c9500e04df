#pragma once

#include <mutex>

#include <boost/shared_ptr.hpp>

namespace AL {

/// A lock that its own thread may take again.
class ALMutex {
 public:
  static boost::shared_ptr<ALMutex> createALMutex() {
    return boost::shared_ptr<ALMutex>(new ALMutex);
  }
  virtual ~ALMutex() {}

  int lock() { return mutex_.lock(), 0; }
  int unlock() { return mutex_.unlock(), 0; }
  bool tryLock() { return mutex_.try_lock(); }

 private:
  std::recursive_mutex mutex_;
};

}  // namespace AL
