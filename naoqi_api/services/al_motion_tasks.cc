#include "naoqi_api/services/al_motion_tasks.h"

#include <algorithm>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {

void AlMotionTasks::declare(rpc::Service& service) {
  using Self = AlMotionTasks;
  const rpc::Argument names{"resourceNames", "Names of joints or chains."};
  addMethod(service, "getTaskList", this, &Self::getTaskList,
            "The motions under way: [[name, number], ...].")
      .at(284);
  addMethod(service, "areResourcesAvailable", this, &Self::areResourcesAvailable,
            "Whether no motion has booked any of these joints.", names)
      .at(285);
  addMethod(service, "killTask", this, &Self::killTask,
            "Ends a motion; true if there was one of this number.",
            rpc::Argument{"motionTaskID", "A number from getTaskList."})
      .at(286);
  addMethod(service, "killTasksUsingResources", this, &Self::killTasksUsingResources,
            "Ends the motions that have booked any of these joints.", names)
      .at(287);
  addMethod(service, "killAll", this, &Self::killAll, "Ends all motions.").at(290);
}

rpc::Pending<rpc::Value> AlMotionTasks::getTaskList() {
  return link_.whenSettled([this] {
    std::vector<rpc::Value> list;
    for (const motion::Task& task : link_.state()->tasks) {
      list.push_back(rpc::Value::list({task.name, static_cast<int>(task.id)}));
    }
    return rpc::Value::list(std::move(list));
  });
}

std::vector<motion::RequestId> AlMotionTasks::tasksUsing(const std::vector<Joint>& joints) const {
  std::vector<motion::RequestId> using_them;
  for (const motion::Task& task : link_.state()->tasks) {
    const auto books = [&](Joint joint) {
      return std::find(task.joints.begin(), task.joints.end(), joint) != task.joints.end();
    };
    if (std::any_of(joints.begin(), joints.end(), books)) using_them.push_back(task.id);
  }
  return using_them;
}

rpc::Pending<bool> AlMotionTasks::areResourcesAvailable(const std::vector<std::string>& names) {
  const auto joints = jointsNamed(link_.model(), names);
  return link_.whenSettled([this, joints] { return tasksUsing(joints).empty(); });
}

rpc::Pending<bool> AlMotionTasks::killTask(int task) {
  return link_.whenSettled([this, task] {
    const auto id = static_cast<motion::RequestId>(task);
    const auto state = link_.state();
    const bool is_there =
        std::any_of(state->tasks.begin(), state->tasks.end(),
                    [id](const motion::Task& running) { return running.id == id; });
    if (is_there) link_.post(motion::Kill{id});
    return is_there;
  });
}

rpc::Pending<void> AlMotionTasks::killTasksUsingResources(const std::vector<std::string>& names) {
  const auto joints = jointsNamed(link_.model(), names);
  rpc::Pending<void> done;
  link_.until({}).whenDone([this, joints, done](const auto& /*settled*/) {
    try {
      for (const motion::RequestId id : tasksUsing(joints)) link_.post(motion::Kill{id});
      done.resolve();
    } catch (const rpc::CallError& error) {
      done.fail(error.what());
    }
  });
  return done;
}

void AlMotionTasks::killAll() { link_.post(motion::KillAll{}); }

}  // namespace nao::services
