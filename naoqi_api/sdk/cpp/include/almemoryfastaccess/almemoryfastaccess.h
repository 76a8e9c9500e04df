#pragma once

#include <string>
#include <vector>

#include <boost/shared_ptr.hpp>

#include <alcommon/albroker.h>
#include <alcommon/alproxy.h>
#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/export.h>
#include <usarnaoqi_sdk/memory_pointer.h>

namespace AL {

/// Reads a list of ALMemory's keys at once: one message there and one back.
class USARNAOQI_SDK_API ALMemoryFastAccess {
 public:
  ALMemoryFastAccess() {}

  /// The keys that GetValues() reads, in their order. One that is not there is left out, or an
  /// ALError: as `leave_out_missing` says.
  void ConnectToVariables(boost::shared_ptr<ALBroker> broker, const std::vector<std::string>& keys,
                          bool leave_out_missing = false);

  void ConnectToIntVariables(boost::shared_ptr<ALBroker> broker,
                             const std::vector<std::string>& keys) {
    ConnectToVariables(broker, keys);
  }
  /// Reads nothing from now on.
  void StopAllAccess() { memory_.reset(); }

  /// Their numbers; 0 for what is none. @throws ALError before ConnectToVariables()
  void GetValues(std::vector<float>& values) const;
  void GetValues(std::vector<int>& values) const;
  void GetValues(ALValue& values) const;
  /// Sets them, in their order. @throws ALError before ConnectToVariables(), or for another count.
  void SetValues(const std::vector<float>& values);
  void SetValues(const std::vector<int>& values);
  /// @throws ALError before ConnectToVariables()
  void insertBuffer(const std::string& key, const ALValue& bytes);

  /// A key's int or float, as it is in each cycle: see ALMemoryProxy::getDataPtr(). NULL for one
  /// that is not there, or an ALError: as `leave_out_missing` says.
  static void* getDataPtr(boost::shared_ptr<ALBroker> broker, const std::string& key,
                          bool leave_out_missing = false);
  /// The same, of a key that is made with `value` if it is not there.
  template <class T, class Proxy>
  static T* getSafeDataPtr(boost::shared_ptr<Proxy> memory, const std::string& key, T value) {
    try {
      memory->callVoid("getData", key);
    } catch (const ALError&) {
      memory->callVoid("insertData", key, value);
    }
    return static_cast<T*>(detail::memoryPointer(*memory, key));
  }

 private:
  ALProxy& memory(const char* method) const;
  template <class T>
  void read(std::vector<T>& values) const;
  void write(const ALValue& values);

  boost::shared_ptr<ALProxy> memory_;
  ALValue keys_;
};

}  // namespace AL
