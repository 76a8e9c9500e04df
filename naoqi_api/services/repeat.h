#pragma once

#include <functional>
#include <memory>

#include "naoqi_api/tasks.h"

namespace nao::services {

/// Calls `work` every `period` of simulated time as long as `owner` lives.
inline void repeat(const rpc::CallLater& later, Duration period, const std::weak_ptr<void>& owner,
                   const std::function<void()>& work) {
  later(period, [later, period, owner, work] {
    const auto alive = owner.lock();
    if (!alive) return;
    work();
    repeat(later, period, owner, work);
  });
}

}  // namespace nao::services
