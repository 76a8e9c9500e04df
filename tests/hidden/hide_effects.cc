// Hides effects in one set and keeps what they are apart: usarnaoqi-hide.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

#include "core/check.h"
#include "core/files.h"
#include "core/random.h"
#include "tests/hidden/hidden_set.h"
#include "tests/hidden/preset.h"

namespace nao::hidden {
namespace {

struct Arguments {
  std::vector<std::string> effects, joints;
  int n = 1;
  std::uint64_t seed = 1;
  double size = 8;
  std::optional<double> value;
  std::string scene = "hung_up", level = "joint";
  int repeats = 6;
  std::string folder, robots_dir = NAO_SOURCE_DIR "/robots";
};

std::vector<Hideout> allHideouts(const Arguments& arguments) {
  if (arguments.scene != "hung_up") {
    std::vector<Hideout> all = robotHideouts();
    all.push_back(hullHideout());
    return all;
  }
  if (arguments.level == "limb") return limbHideouts();
  std::vector<Hideout> all = catalogueHideouts();
  for (const auto& more : {likenessHideouts(), strangerHideouts()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

// A cause ("joint_stop.upper"), an effect ("joint_stop") or a law of this folder.
bool is(const Hideout& hideout, const std::string& name) {
  return hideout.cause == name || hideout.law == name;
}

// As large as the user says, where that is given.
Hideout asAsked(Hideout hideout, const Arguments& arguments) {
  if (arguments.value) hideout.start = hideout.most = *arguments.value;
  return hideout;
}

std::vector<Hideout> waysOf(const Arguments& arguments, const std::string& name) {
  std::vector<Hideout> ways;
  std::set<std::string> known;
  for (const Hideout& hideout : allHideouts(arguments)) {
    known.insert(hideout.cause.empty() ? hideout.law : hideout.cause);
    if (is(hideout, name)) ways.push_back(asAsked(hideout, arguments));
  }
  if (!ways.empty()) return ways;
  std::string list;
  for (const std::string& one : known) list += " " + one;
  throw InputError("--effects: expected some of" + list + ", found '" + name + "'");
}

// `n` different ones of those that were asked for, or of the catalogue's; of each one way.
std::vector<Wish> wishesOf(const Arguments& arguments, Random& random) {
  std::vector<std::string> names = arguments.effects;
  if (names.empty()) {
    const bool hung_up = arguments.scene == "hung_up" && arguments.level == "joint";
    for (const Hideout& hideout : hung_up ? catalogueHideouts() : allHideouts(arguments)) {
      names.push_back(hideout.cause);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
  }
  if (arguments.n > static_cast<int>(names.size())) {
    throw InputError("--n: expected at most " + std::to_string(names.size()) + ", found " +
                     std::to_string(arguments.n));
  }
  const auto pick = [&](std::size_t count) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  };
  std::vector<Wish> wishes;
  for (int i = 0; i < arguments.n; ++i) {
    const std::size_t at = pick(names.size());
    const std::vector<Hideout> ways = waysOf(arguments, names[at]);
    wishes.push_back({ways[pick(ways.size())], arguments.size});
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return wishes;
}

HiddenCase caseOf(const Arguments& arguments) {
  for (const std::string& name : arguments.effects) waysOf(arguments, name);
  Random random(arguments.seed, "hide");
  HiddenCase hidden;
  hidden.seed = 1 + static_cast<std::uint64_t>(random.uniform() * 1e15);
  hidden.kind = arguments.n == 0 ? Kind::NearNull : arguments.n == 1 ? Kind::Single : Kind::Pair;
  hidden.wishes = wishesOf(arguments, random);
  hidden.joints = arguments.joints;
  hidden.repeats = arguments.repeats;
  hidden.level = arguments.level;
  hidden.scene = sceneOf(arguments.scene);
  if (hidden.scene != Scene::HungUp) return hidden;
  for (const Wish& wish : hidden.wishes) {
    const std::string& needs = wish.hideout.needs;
    if (hidden.joints.empty() || hidden.joints.front().find(needs) != std::string::npos) continue;
    throw InputError("--joints: " + wish.hideout.cause + " needs an " + needs + " first, found " +
                     hidden.joints.front());
  }
  if (!hidden.joints.empty()) return hidden;
  const bool ankle = std::any_of(hidden.wishes.begin(), hidden.wishes.end(),
                                 [](const Wish& wish) { return !wish.hideout.needs.empty(); });
  if (ankle) {
    hidden.joints = {"LAnkleRoll", "LAnklePitch"};
    return hidden;
  }
  hidden.joints = {"LShoulderPitch"};
  hidden.other_places = {"LKneePitch", "HeadYaw", "RElbowYaw", "RHipRoll", "RAnklePitch"};
  return hidden;
}

void run(const Arguments& arguments) {
  namespace fs = std::filesystem;
  if (fs::exists(arguments.folder)) {
    throw InputError("-o " + arguments.folder + ": expected a folder that is not yet there");
  }
  HiddenCase hidden = caseOf(arguments);
  const auto model = loadRobotModel(arguments.robots_dir, hidden.robot());
  for (const std::string& joint : hidden.joints) {
    if (!model->findJoint(joint) && model->groups.count(joint) == 0)
      throw InputError("--joints: no joint is called " + joint);
  }
  const HiddenSet made = makeHiddenSetSomewhere(hidden, model);
  if (!made.truth.shortfall.empty()) {
    throw InputError("nothing was hidden: " + made.truth.shortfall +
                     "try other --joints, --size or --seed");
  }
  validation::writeLogSet(made.set, arguments.folder);
  const std::string truth = fs::path(arguments.folder).lexically_normal().string() + ".truth.json";
  writeFile("", truth, toJson(made.truth) + "\n");
  std::printf("%s: diagnose it with --model %s; what is hidden stands in %s\n",
              arguments.folder.c_str(), hidden.robot().c_str(), truth.c_str());
}

}  // namespace
}  // namespace nao::hidden

int main(int argc, char** argv) {
  using namespace nao::hidden;
  CLI::App app("Records a set from a simulated robot in which something is wrong.");
  Arguments arguments;
  app.add_option("--effects", arguments.effects,
                 "Causes of `usarnaoqi catalog` to draw from, or laws of tests/hidden; default: "
                 "all of the catalogue.")
      ->delimiter(',');
  app.add_option("--n", arguments.n, "How many of them are hidden at once; 0: none.")
      ->capture_default_str()
      ->check(CLI::Range(0, 5));
  app.add_option("--seed", arguments.seed, "Another number, another set.")->capture_default_str();
  app.add_option("--joints", arguments.joints,
                 "That move and are written; effects hide in the first. Default: one that shows "
                 "them.")
      ->delimiter(',');
  app.add_option("--size", arguments.size, "Of each effect, in SDs of the measured mean.")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 1000.0));
  app.add_option("--value", arguments.value,
                 "Of the effect's parameter, less its neutral value, in place of a size.");
  app.add_option("--scene", arguments.scene,
                 "What the robot does: hung_up, stand, kick, balance, walk, turn or circle.")
      ->capture_default_str();
  app.add_option("--level", arguments.level, "Whose causes are hidden: joint or limb.")
      ->capture_default_str()
      ->check(CLI::IsMember({"joint", "limb"}));
  app.add_option("--repeats", arguments.repeats, "Of each motion.")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  app.add_option("--robots-dir", arguments.robots_dir, "The nominal models.");
  app.add_option("-o,--out", arguments.folder, "Folder of the set; SET.truth.json is beside it.")
      ->required();
  try {
    app.parse(argc, argv);
    run(arguments);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const nao::InputError& error) {
    std::fprintf(stderr, "usarnaoqi-hide: %s\n", error.what());
    return 2;
  }
}
