#pragma once

#include <string>
#include <vector>

#include <boost/shared_ptr.hpp>

#include <alcommon/albroker.h>
#include <usarnaoqi_sdk/export.h>

namespace AL {

/// The brokers of this program: it keeps those that are added until they are removed or killed.
class USARNAOQI_SDK_API ALBrokerManager {
 public:
  static boost::shared_ptr<ALBrokerManager> getInstance();
  static void setInstance(boost::shared_ptr<ALBrokerManager> manager);
  /// Lets go of the manager, and so of its brokers.
  static void kill();

  void addBroker(boost::shared_ptr<ALBroker> broker);
  void removeBroker(boost::shared_ptr<ALBroker> broker);
  /// Shuts all of them down.
  void killAllBroker();
  void killBroker(const std::string& name);
  /// Null if there is none.
  boost::shared_ptr<ALBroker> getBrokerByName(const std::string& name) const;
  boost::shared_ptr<ALBroker> getRandomBroker() const;

 private:
  std::vector<boost::shared_ptr<ALBroker> > brokers_;
};

}  // namespace AL
