#include "naoqi_api/sdk/cpp/src/qi_application.h"

#include <mutex>
#include <qi/application.hpp>
#include <utility>
#include <vector>

namespace {

struct Acts {
  std::mutex mutex;
  std::vector<std::function<void()>> all;
};

// Never destroyed: static objects of the program may still leave something.
Acts& acts() {
  static Acts* the_acts = new Acts;
  return *the_acts;
}

}  // namespace

bool qi::Application::atStop(std::function<void()> act) {
  const std::lock_guard<std::mutex> lock(acts().mutex);
  acts().all.push_back(std::move(act));
  return true;
}

void nao::client::actAtStop() {
  std::vector<std::function<void()>> all;
  {
    const std::lock_guard<std::mutex> lock(acts().mutex);
    all.swap(acts().all);
  }
  for (const auto& act : all) act();
}
