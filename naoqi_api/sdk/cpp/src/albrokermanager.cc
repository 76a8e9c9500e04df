#include <alcommon/albrokermanager.h>

#include <algorithm>
#include <mutex>

namespace AL {
namespace {

struct Place {
  std::mutex mutex;
  boost::shared_ptr<ALBrokerManager> manager;
};

// Never destroyed: modules that still live at the end of a program may ask for it.
Place& place() {
  static Place* the_place = new Place;
  return *the_place;
}

}  // namespace

boost::shared_ptr<ALBrokerManager> ALBrokerManager::getInstance() {
  const std::lock_guard<std::mutex> lock(place().mutex);
  if (!place().manager) place().manager.reset(new ALBrokerManager);
  return place().manager;
}

void ALBrokerManager::setInstance(boost::shared_ptr<ALBrokerManager> manager) {
  const std::lock_guard<std::mutex> lock(place().mutex);
  place().manager = manager;
}

void ALBrokerManager::kill() {
  boost::shared_ptr<ALBrokerManager> manager;
  const std::lock_guard<std::mutex> lock(place().mutex);
  manager.swap(place().manager);
}

void ALBrokerManager::addBroker(boost::shared_ptr<ALBroker> broker) {
  if (std::find(brokers_.begin(), brokers_.end(), broker) == brokers_.end()) {
    brokers_.push_back(broker);
  }
}

void ALBrokerManager::removeBroker(boost::shared_ptr<ALBroker> broker) {
  brokers_.erase(std::remove(brokers_.begin(), brokers_.end(), broker), brokers_.end());
}

void ALBrokerManager::killAllBroker() {
  std::vector<boost::shared_ptr<ALBroker>> brokers;
  brokers.swap(brokers_);
  for (const auto& broker : brokers) broker->shutdown();
}

void ALBrokerManager::killBroker(const std::string& name) {
  const boost::shared_ptr<ALBroker> broker = getBrokerByName(name);
  if (!broker) return;
  broker->shutdown();
  removeBroker(broker);
}

boost::shared_ptr<ALBroker> ALBrokerManager::getBrokerByName(const std::string& name) const {
  for (const auto& broker : brokers_) {
    if (broker->getName() == name) return broker;
  }
  return {};
}

boost::shared_ptr<ALBroker> ALBrokerManager::getRandomBroker() const {
  return brokers_.empty() ? boost::shared_ptr<ALBroker>() : brokers_.front();
}

}  // namespace AL
