#pragma once

#include <boost/shared_ptr.hpp>

#include <althread/almutex.h>

namespace AL {

/// Holds a mutex as long as it lives.
class ALCriticalSection {
 public:
  explicit ALCriticalSection(boost::shared_ptr<ALMutex> mutex) : mutex_(mutex) {
    if (mutex_) mutex_->lock();
  }
  explicit ALCriticalSection(ALMutex& mutex) : plain_(&mutex) { plain_->lock(); }
  ~ALCriticalSection() {
    if (mutex_) mutex_->unlock();
    if (plain_) plain_->unlock();
  }
  ALCriticalSection(const ALCriticalSection&) = delete;
  ALCriticalSection& operator=(const ALCriticalSection&) = delete;

 private:
  boost::shared_ptr<ALMutex> mutex_;
  ALMutex* plain_ = nullptr;
};

}  // namespace AL
