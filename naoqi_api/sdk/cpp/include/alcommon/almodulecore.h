#pragma once

#include <string>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>

#include <usarnaoqi_sdk/export.h>
#include <usarnaoqi_sdk/process_signals.h>

namespace AL {

/// What a module is to others of its process.
class USARNAOQI_SDK_API ALModuleCore : public ALProcessSignals {
 public:
  explicit ALModuleCore(const std::string& name) : name_(name) {}
  virtual ~ALModuleCore() {}

  const std::string& getName() const { return name_; }

 private:
  std::string name_;
};

}  // namespace AL
