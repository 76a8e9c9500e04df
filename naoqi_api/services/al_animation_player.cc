#include "naoqi_api/services/al_animation_player.h"

#include <map>
#include <string>
#include <vector>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using Names = std::vector<std::string>;

constexpr std::size_t kMostTags = 1024;  // free: what clients may leave behind
constexpr std::size_t kMostPaths = 64;   // the same

class AlAnimationPlayer {
 public:
  explicit AlAnimationPlayer(std::shared_ptr<BehaviorRunner> runner) : runner_(std::move(runner)) {}
  void declare(rpc::Service& service);

 private:
  rpc::Pending<void> run(const std::string& animation);
  rpc::Pending<void> runTag(const std::string& tag);
  void addTagForAnimations(const std::map<std::string, Names>& tags);
  void declarePathForTags(const std::string& path);
  void reset();

  std::string find(const std::string& animation) const;

  std::shared_ptr<BehaviorRunner> runner_;
  std::map<std::string, Names> tags_;
  std::map<std::string, std::size_t> turn_;  // of each tag: which of its animations is next
  Names paths_;
};

void AlAnimationPlayer::declare(rpc::Service& service) {
  using Self = AlAnimationPlayer;
  addMethod(service, "run", this, &Self::run, "Plays an animation and waits for its end.",
            rpc::Argument{"animation", "Name of an installed motion, for instance hello."});
  addMethod(service, "runTag", this, &Self::runTag,
            "Plays one of the animations of a tag, each in turn, and waits for its end.",
            rpc::Argument{"tag",
                          "A tag that addTagForAnimations or a manifest has told, or a\n"
                          "folder of installed motions."});
  addMethod(service, "addTagForAnimations", this, &Self::addTagForAnimations,
            "Gives animations a tag.", rpc::Argument{"tagToAnims", "Names of animations by tag."});
  addMethod(
      service, "declarePathForTags", this, &Self::declarePathForTags,
      "From now on the animations of tags are also looked for here.",
      rpc::Argument{"path", "Folders before an animation's name, as the library counts them."});
  addMethod(service, "reset", this, &Self::reset, "Forgets the tags and paths that were told.");
}

std::string AlAnimationPlayer::find(const std::string& animation) const {
  for (const std::string& path : paths_) {
    std::string found = runner_->library().resolve(path + "/" + animation);
    if (!found.empty()) return found;
  }
  return runner_->library().resolve(animation);
}

rpc::Pending<void> AlAnimationPlayer::run(const std::string& animation) {
  const std::string found = find(animation);
  if (found.empty()) {
    throw rpc::CallError("the animation \"" + animation.substr(0, 200) +
                         "\" is not on this robot; ALBehaviorManager.getInstalledBehaviors lists "
                         "those there are");
  }
  Performance& playback = runner_->load(found);
  playback.start();
  return playback.untilEnd();
}

rpc::Pending<void> AlAnimationPlayer::runTag(const std::string& tag) {
  Names candidates;
  const auto told = tags_.find(tag);
  if (told != tags_.end()) candidates = told->second;
  for (std::string& name : runner_->library().namesByTag(tag))
    candidates.push_back(std::move(name));
  for (const std::string& name : runner_->library().names()) {
    if (!tag.empty() && name.rfind(tag + "/", 0) == 0) candidates.push_back(name);
  }
  if (candidates.empty()) {
    throw rpc::CallError("no animation of this robot has the tag \"" + tag.substr(0, 200) + "\"");
  }
  if (turn_.size() >= kMostTags) turn_.clear();
  return run(candidates[turn_[tag]++ % candidates.size()]);
}

void AlAnimationPlayer::addTagForAnimations(const std::map<std::string, Names>& tags) {
  if (tags_.size() + tags.size() > kMostTags) throw rpc::CallError("too many tags");
  for (const auto& [tag, animations] : tags) {
    for (const std::string& animation : animations) {
      if (find(animation).empty()) {
        throw rpc::CallError("the animation \"" + animation.substr(0, 200) +
                             "\" is not on this robot");
      }
    }
  }
  for (const auto& [tag, animations] : tags) tags_[tag] = animations;
}

void AlAnimationPlayer::declarePathForTags(const std::string& path) {
  if (paths_.size() >= kMostPaths) throw rpc::CallError("too many paths");
  paths_.push_back(path);
}

void AlAnimationPlayer::reset() {
  tags_.clear();
  turn_.clear();
  paths_.clear();
}

}  // namespace

std::shared_ptr<rpc::Service> makeAlAnimationPlayer(std::shared_ptr<BehaviorRunner> runner) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALAnimationPlayer", "Plays installed motions by name or by tag."));
  const auto player = std::make_shared<AlAnimationPlayer>(std::move(runner));
  player->declare(*service);
  service->owning(player);
  return service;
}

}  // namespace nao::services
