#include "naoqi_api/services/al_robot_posture.h"

#include <algorithm>
#include <string>
#include <vector>

#include "motion/postures.h"
#include "naoqi_api/al_module.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/posture_library.h"

namespace nao::services {
namespace {

constexpr std::uint32_t kFirstFreeUid = 155;  // after the last one of a V5

class AlRobotPosture {
 public:
  AlRobotPosture(RobotLink& link, const std::filesystem::path& data_dir)
      : link_(link), library_(link, data_dir) {}
  void declare(rpc::Service& service);

 private:
  rpc::Pending<bool> goToPosture(const std::string& name, float fraction);
  void stopMove();
  std::vector<std::string> getPostureList();
  std::vector<std::string> getPostureFamilyList();
  std::string getPosture();
  std::string getPostureFamily();
  void setMaxTryNumber(int tries);

  void attempt(const motion::GoToPosture& request, int tries_left, const rpc::Pending<bool>& done);

  RobotLink& link_;
  PostureLibrary library_;
  int max_tries_ = 3;                // NaoQi's default
  motion::RequestId under_way_ = 0;  // the request posted last
};

void AlRobotPosture::declare(rpc::Service& service) {
  using Self = AlRobotPosture;
  const rpc::Argument name{"postureName", "Name of the posture, for instance StandInit."};
  const rpc::Argument fraction{"maxSpeedFraction", "Part of the maximum speed, up to 1."};
  addMethod(service, "getPostureFamily", this, &Self::getPostureFamily,
            "The family of the posture the robot is in, for instance Standing.")
      .at(113);
  addMethod(service, "goToPosture", this, &Self::goToPosture,
            "Brings the robot into a posture; true if it gets there.", name, fraction)
      .at(114);
  addMethod(service, "applyPosture", this, &Self::goToPosture,
            "Brings the robot into a posture; true if it gets there.", name, fraction)
      .at(115);
  addMethod(service, "stopMove", this, &Self::stopMove, "Ends goToPosture where the robot is.")
      .at(116);
  addMethod(service, "getPostureList", this, &Self::getPostureList, "The postures there are.")
      .at(117);
  addMethod(service, "getPostureFamilyList", this, &Self::getPostureFamilyList,
            "The families of postures there are.")
      .at(118);
  addMethod(service, "setMaxTryNumber", this, &Self::setMaxTryNumber,
            "How often goToPosture tries before it gives up.",
            rpc::Argument{"pMaxTryNumber", "At least 1."})
      .at(119);
  addMethod(service, "getPosture", this, &Self::getPosture,
            "The posture the robot is in, or Unknown.")
      .at(120);
  library_.declare(service);
}

rpc::Pending<bool> AlRobotPosture::goToPosture(const std::string& name, float fraction) {
  if (library_.holds(name)) return library_.goTo(name, readFraction(fraction));
  if (link_.model().findPosture(name) == nullptr) {
    throw rpc::CallError("unknown posture name: " + name);
  }
  rpc::Pending<bool> done;
  attempt({name, readFraction(fraction)}, max_tries_, done);
  library_.follow(name, done);
  return done;
}

void AlRobotPosture::attempt(const motion::GoToPosture& request, int tries_left,
                             const rpc::Pending<bool>& done) {
  under_way_ = link_.post(request);
  const auto outcome = link_.outcomeOf(under_way_);
  done.onCancel(outcome.canceler());
  outcome.whenDone([this, request, tries_left, done](const auto& ended) {
    using Kind = motion::MotionOutcome::Kind;
    if (ended.isCanceled()) return done.cancelNow();
    if (ended.value->kind != Kind::Failed || tries_left <= 1) {
      return done.resolve(ended.value->kind == Kind::Done);
    }
    try {
      attempt(request, tries_left - 1, done);
    } catch (const rpc::CallError& error) {
      done.fail(error.what());
    }
  });
}

void AlRobotPosture::stopMove() {
  if (under_way_ != 0) link_.post(motion::Kill{under_way_});
}

std::vector<std::string> AlRobotPosture::getPostureList() {
  std::vector<std::string> names;
  for (const Posture& posture : link_.model().postures) {
    if (posture.name.rfind('_', 0) != 0) names.push_back(posture.name);  // NaoQi's own ones
  }
  for (const std::string& name : library_.savedNames()) names.push_back(name);
  return names;
}

std::vector<std::string> AlRobotPosture::getPostureFamilyList() {
  std::vector<std::string> families;
  for (const Posture& posture : link_.model().postures) {
    if (std::find(families.begin(), families.end(), posture.family) == families.end()) {
      families.push_back(posture.family);
    }
  }
  return families;
}

std::string AlRobotPosture::getPosture() {
  const Posture* posture = motion::findCurrentPosture(link_.model(), *link_.sensors());
  return posture == nullptr ? "Unknown" : posture->name;
}

std::string AlRobotPosture::getPostureFamily() {
  return motion::currentFamily(link_.model(), *link_.sensors());
}

void AlRobotPosture::setMaxTryNumber(int tries) {
  if (tries < 1) throw rpc::CallError("the number of tries must be at least 1");
  max_tries_ = tries;
}

}  // namespace

std::shared_ptr<rpc::Service> makeAlRobotPosture(RobotLink& link,
                                                 const std::filesystem::path& data_dir) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALRobotPosture", "Named postures of the whole body."));
  service->startAt(kFirstFreeUid);
  const auto posture = std::make_shared<AlRobotPosture>(link, data_dir);
  posture->declare(*service);
  service->owning(posture);
  return service;
}

}  // namespace nao::services
