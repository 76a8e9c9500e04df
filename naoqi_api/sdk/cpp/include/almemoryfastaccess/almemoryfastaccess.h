#pragma once

#include <string>
#include <vector>

#include <boost/shared_ptr.hpp>

#include <alcommon/albroker.h>
#include <alcommon/alproxy.h>
#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/export.h>

namespace AL {

/// Reads a list of ALMemory's keys at once: one message there and one back.
class USARNAOQI_SDK_API ALMemoryFastAccess {
 public:
  ALMemoryFastAccess() {}

  /// The keys that GetValues() reads, in their order. One that is not there is left out, or an
  /// ALError: as `leave_out_missing` says.
  void ConnectToVariables(boost::shared_ptr<ALBroker> broker, const std::vector<std::string>& keys,
                          bool leave_out_missing = false);

  /// Their numbers; 0 for what is none. @throws ALError before ConnectToVariables()
  void GetValues(std::vector<float>& values);
  void GetValues(ALValue& values);

 private:
  ALValue read() const;

  boost::shared_ptr<ALProxy> memory_;
  ALValue keys_;
};

}  // namespace AL
