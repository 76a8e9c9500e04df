#include "tests/hidden/preset.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/random.h"
#include "tests/hidden/mujoco/recording.h"

namespace nao::hidden {
namespace {

// Joints of every limb and motor type. An ankle's roll comes with the pitch that limits it.
const std::vector<std::vector<std::string>>& places() {
  static const std::vector<std::vector<std::string>> kPlaces{
      {"LKneePitch"},    {"HeadYaw"},      {"LShoulderPitch"}, {"RHipRoll"},
      {"LElbowRoll"},    {"RAnklePitch"},  {"HeadPitch"},      {"LHipPitch"},
      {"RShoulderRoll"}, {"LHipYawPitch"}, {"RElbowYaw"},      {"LAnkleRoll", "LAnklePitch"},
  };
  return kPlaces;
}

constexpr int kRobotRepeats = 8;        // of a motion on the feet
constexpr std::size_t kMostPlaces = 6;  // where an effect is tried before a case is given up

// A second and third joint for sets of several.
const std::vector<std::vector<std::string>>& groups() {
  static const std::vector<std::vector<std::string>> kGroups{
      {"LKneePitch", "LAnklePitch"},
      {"HeadYaw", "HeadPitch"},
      {"LShoulderPitch", "LElbowRoll"},
      {"RHipRoll", "RHipPitch", "RKneePitch"},
  };
  return kGroups;
}

class Dealer {
 public:
  explicit Dealer(std::uint64_t seed) : seed_(seed), random_(seed, "hidden cases") {}

  std::vector<HiddenCase> deal(const Counts& counts) {
    seconds_ = counts.seconds;
    for (int i = 0; i < counts.exact_nulls; ++i) addNull(Kind::ExactNull, i);
    for (int i = 0; i < counts.near_nulls; ++i) addNull(Kind::NearNull, i);
    for (int i = 0; i < counts.singles; ++i) addSingle(i);
    for (int i = 0; i < counts.weak_singles; ++i) addWeak();
    for (int i = 0; i < counts.pairs; ++i) addPair();
    for (int i = 0; i < counts.strangers; ++i) addStranger(i);
    for (int i = 0; i < counts.data_faults; ++i) addDataFault(i);
    if (hasMujoco()) {
      for (int i = 0; i < counts.mujoco_nulls; ++i) {
        addNull(i % 2 == 0 ? Kind::MujocoExactNull : Kind::MujocoNull, i);
      }
      for (int i = 0; i < counts.mujoco_singles; ++i) addMujocoSingle();
    }
    for (int i = 0; i < counts.limb_nulls; ++i) addLimb(Kind::NearNull);
    for (int i = 0; i < counts.limb_singles; ++i) addLimb(Kind::Single);
    for (int i = 0; i < counts.robot_nulls; ++i) addRobot(Kind::NearNull, i);
    for (int i = 0; i < counts.robot_singles; ++i) addRobot(Kind::Single, i);
    shuffle();
    return std::move(cases_);
  }

 private:
  std::size_t pick(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  double sizeOfSingle() { return std::exp(random_.uniform(std::log(6.0), std::log(15.0))); }

  HiddenCase& add(Kind kind) {
    HiddenCase hidden;
    hidden.kind = kind;
    hidden.seconds = seconds_;
    hidden.seed = 1 + static_cast<std::uint64_t>(random_.uniform() * 1e15);
    cases_.push_back(hidden);
    return cases_.back();
  }

  void addNull(Kind kind, int i) {
    HiddenCase& hidden = add(kind);
    const auto n = static_cast<std::size_t>(i);
    hidden.joints = i % 4 == 3 ? groups()[n / 4 % groups().size()] : places()[n % places().size()];
  }

  void place(HiddenCase& hidden, std::size_t first) {
    hidden.joints = places()[first % places().size()];
    for (std::size_t i = 1; i <= kMostPlaces; ++i) {
      const auto& other = places()[(first + 5 * i) % places().size()];
      if (other.size() == 1) hidden.other_places.push_back(other.front());
    }
  }

  // Each list is gone round from a place drawn once, so that every cause has its turn.
  const Hideout& next(const std::vector<Hideout>& list, std::size_t& at) {
    if (at == kNowhere) at = pick(list.size());
    return list[at++ % list.size()];
  }

  // Of weak effects, those that are of interest when they are as small as noise.
  static std::vector<Hideout> faint(const std::vector<Hideout>& all) {
    std::vector<Hideout> kept;
    for (const Hideout& hideout : all) {
      static const char* const kFaint[] = {"friction",      "torque_bias", "kd_error",
                                           "motor_inertia", "link_com",    "thermal"};
      const auto is = [&](const char* word) {
        return hideout.cause.find(word) == 0 ||
               hideout.cause.find(std::string("_") + word) != std::string::npos;
      };
      if (hideout.whole_robot || !std::any_of(std::begin(kFaint), std::end(kFaint), is)) continue;
      kept.push_back(hideout);
    }
    return kept;
  }

  void addWeak() {
    HiddenCase& hidden = add(Kind::WeakSingle);
    hidden.wishes = {{next(faint_, at_faint_), 1.5}};
    place(hidden, pick(places().size()));
  }

  void addSingle(int i) {
    HiddenCase& hidden = add(Kind::Single);
    const Hideout& hideout = i % 5 < 2 ? next(likeness_, at_likeness_) : next(own_, at_own_);
    hidden.wishes = {{hideout, sizeOfSingle()}};
    place(hidden, pick(places().size()));
    if (hideout.needs.empty()) return;
    hidden.joints = places().back();
    hidden.other_places.clear();
  }

  void addMujocoSingle() {
    HiddenCase& hidden = add(Kind::MujocoSingle);
    hidden.wishes = {{next(mujoco_, at_mujoco_), sizeOfSingle()}};
    place(hidden, pick(places().size()));
  }

  void addPair() {
    HiddenCase& hidden = add(Kind::Pair);
    const Hideout* first = &next(own_, at_own_);
    while (!first->needs.empty()) first = &next(own_, at_own_);
    hidden.wishes = {{*first, sizeOfSingle()}, {partnerOf(*first), sizeOfSingle()}};
    place(hidden, pick(places().size()));
    for (std::size_t i = 0; i < hidden.other_places.size(); ++i) {
      hidden.spares.push_back({partnerOf(*first), sizeOfSingle()});
    }
  }

  // Another cause that any joint can show.
  const Hideout& partnerOf(const Hideout& first) {
    while (true) {
      const Hideout& second = own_[pick(own_.size())];
      if (!looksAlike(second.cause, first.cause) && second.needs.empty()) return second;
    }
  }

  void addStranger(int i) {
    HiddenCase& hidden = add(Kind::Stranger);
    hidden.wishes = {{strangers_[static_cast<std::size_t>(i) % strangers_.size()], sizeOfSingle()}};
    place(hidden, pick(places().size()));
  }

  // All joints of a leg move and are written; the other leg hangs on the same motor.
  void addLimb(Kind kind) {
    HiddenCase& hidden = add(kind);
    hidden.level = "limb";
    hidden.joints = {"LHipYawPitch", "LHipRoll",    "LHipPitch",
                     "LKneePitch",   "LAnklePitch", "LAnkleRoll"};
    if (kind == Kind::Single) hidden.wishes = {{next(limb_, at_limb_), sizeOfSingle()}};
  }

  void addRobot(Kind kind, int i) {
    HiddenCase& hidden = add(kind);
    hidden.level = "robot";
    constexpr Scene kScenes[] = {Scene::Walk, Scene::Kick, Scene::Turn, Scene::Stand,
                                 Scene::Circle};
    hidden.scene = kScenes[i % 5];
    hidden.repeats = kRobotRepeats;
    if (kind == Kind::Single) hidden.wishes = {{next(robot_, at_robot_), sizeOfSingle()}};
  }

  void addDataFault(int i) {
    HiddenCase& hidden = add(Kind::DataFault);
    constexpr Spoil kSpoils[] = {Spoil::SwapJoints, Spoil::Negate, Spoil::Degrees, Spoil::Clock,
                                 Spoil::Freeze};
    hidden.spoil = kSpoils[i % 5];
    hidden.joints = groups()[pick(groups().size())];
  }

  void shuffle() {
    for (std::size_t i = cases_.size(); i > 1; --i) std::swap(cases_[i - 1], cases_[pick(i)]);
  }

  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
  std::uint64_t seed_;
  Random random_;
  double seconds_ = 0;  // of a motion
  std::vector<Hideout> own_ = catalogueHideouts(), likeness_ = likenessHideouts(),
                       strangers_ = strangerHideouts(), faint_ = faint(own_),
                       mujoco_ = mujocoHideouts(), limb_ = limbHideouts(), robot_ = robotHideouts();
  std::size_t at_own_ = kNowhere, at_likeness_ = kNowhere, at_faint_ = kNowhere,
              at_mujoco_ = kNowhere, at_limb_ = kNowhere, at_robot_ = kNowhere;
  std::vector<HiddenCase> cases_;
};

}  // namespace

Counts countsOf(const std::string& preset) {
  if (preset == "quick") return {1, 1, 4, 1, 1, 1, 5, 1, 1, 0, 1, 0, 1};
  if (preset == "standard") return {51, 52, 108, 18, 13, 8, 18, 6, 12, 2, 4, 2, 6, 3};
  if (preset == "full") return {150, 150, 300, 60, 60, 56, 24, 20, 50, 8, 24, 12, 36};
  throw InputError("--preset: expected quick, standard or full, found '" + preset + "'");
}

std::vector<HiddenCase> makeCases(const Counts& counts, std::uint64_t seed) {
  return Dealer(seed).deal(counts);
}

}  // namespace nao::hidden
