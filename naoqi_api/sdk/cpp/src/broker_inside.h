#pragma once

#include <alcommon/albroker.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "naoqi_api/sdk/cpp/src/session.h"

struct AL::ALBroker::Inside {
  explicit Inside(std::shared_ptr<nao::client::Session> its) : session(std::move(its)) {}

  const std::shared_ptr<nao::client::Session> session;
  std::mutex mutex;
  std::map<std::string, boost::shared_ptr<ALModule>> modules;
};
