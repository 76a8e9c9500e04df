#include "tests/hidden/hidden_case.h"

#include <nlohmann/json.hpp>

#include "core/random.h"

namespace nao::hidden {

const char* faultOf(Spoil spoil) {
  switch (spoil) {
    case Spoil::None:
      return "";
    case Spoil::SwapJoints:
      return "swapped";
    case Spoil::Negate:
      return "negated";
    case Spoil::Degrees:
      return "units";
    case Spoil::Clock:
      return "clock";
    case Spoil::Freeze:
      return "constant";
  }
  return "";
}

const char* nameOf(Kind kind) {
  switch (kind) {
    case Kind::ExactNull:
      return "exact_null";
    case Kind::NearNull:
      return "near_null";
    case Kind::Single:
      return "single";
    case Kind::WeakSingle:
      return "weak_single";
    case Kind::Pair:
      return "pair";
    case Kind::Stranger:
      return "stranger";
    case Kind::DataFault:
      return "data_fault";
    case Kind::MujocoExactNull:
      return "mujoco_exact_null";
    case Kind::MujocoNull:
      return "mujoco_null";
    case Kind::MujocoSingle:
      return "mujoco_single";
  }
  return "";
}

bool HiddenCase::isMujoco() const {
  return kind == Kind::MujocoExactNull || kind == Kind::MujocoNull || kind == Kind::MujocoSingle;
}

bool HiddenCase::isExactNull() const {
  return kind == Kind::ExactNull || kind == Kind::MujocoExactNull;
}

std::string HiddenCase::robot() const {
  for (const Wish& wish : wishes) {
    if (wish.hideout.law == "hidden_ankle_hull") return "nao_h21_v33_no_hull";
  }
  return "nao_h21_v33";
}

std::string HiddenCase::name() const {
  constexpr char kSigns[] = "abcdefghijkmnpqrstuvwxyz23456789";
  Random random(seed, "name of a hidden set");
  std::string name;
  for (int i = 0; i < 16; ++i) name += kSigns[static_cast<int>(32 * random.uniform())];
  return name;
}

std::string toJson(const Truth& truth) {
  using Json = nlohmann::ordered_json;
  Json hidden = Json::array();
  for (const HiddenTruth& one : truth.hidden) {
    hidden.push_back({{"cause", one.cause},
                      {"law", one.law},
                      {"joint", one.joint},
                      {"parameter", one.parameter},
                      {"value", one.value},
                      {"deviation", one.deviation},
                      {"size", one.size},
                      {"features", one.features},
                      {"look_alikes", one.look_alikes},
                      {"nearest", one.nearest},
                      {"nearest_apart", one.nearest_apart}});
  }
  const Json all = {{"name", truth.name},
                    {"kind", nameOf(truth.kind)},
                    {"level", truth.level},
                    {"scene", truth.scene},
                    {"joints", truth.joints},
                    {"hidden", hidden},
                    {"spoilt", faultOf(truth.spoil)},
                    {"torque_sd", truth.torque_sd},
                    {"torque_time", truth.torque_time},
                    {"start_sd", truth.start_sd},
                    {"imitated", truth.imitated},
                    {"shortfall", truth.shortfall}};
  return all.dump();
}

}  // namespace nao::hidden
