#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/hidden/hideout.h"
#include "tests/hidden/scene.h"

namespace nao::hidden {

enum class Kind {
  ExactNull,
  NearNull,
  Single,
  WeakSingle,
  Pair,
  Stranger,
  DataFault,
  MujocoExactNull,
  MujocoNull,
  MujocoSingle
};

/// "exact_null", "near_null", "single", "weak_single", "pair", "stranger", "data_fault",
/// "mujoco_exact_null", "mujoco_null", "mujoco_single".
const char* nameOf(Kind kind);

/// What is done to the data themselves.
enum class Spoil { None, SwapJoints, Negate, Degrees, Clock, Freeze };

/// The kind of data fault that `check-data` should call it; empty for none.
const char* faultOf(Spoil spoil);

/// One effect that a case asks for.
struct Wish {
  Hideout hideout;
  double size = 0;  // [SD of the measured mean] wanted
};

/// One set to be made, by its place in a preset: the same case, the same set, to the last bit.
struct HiddenCase {
  std::uint64_t seed = 1;  // of this case alone
  Kind kind = Kind::ExactNull;
  std::vector<std::string> joints;  // that move and are written; effects hide in the first
  /// Where else effects may hide if the first joint cannot show them; tried in this order.
  std::vector<std::string> other_places;
  std::vector<Wish> wishes;
  /// What takes the place of the last wish at each of the other places; fewer or none: it stays.
  std::vector<Wish> spares;
  Spoil spoil = Spoil::None;
  int repeats = 6;
  double seconds = 6;  // of each motion
  /// Recorded from the limbs that hold the joints alone: a held torso passes nothing on from limb
  /// to limb. For tests that must be quick; presets that are judged record the whole robot.
  bool limbs = false;
  std::string level = "joint";  // of the diagnosis
  Scene scene = Scene::HungUp;

  bool isMujoco() const;     // its reality is MuJoCo
  bool isExactNull() const;  // not even undeclared differences
  /// The nominal model, of robots/.
  std::string robot() const;
  /// 16 letters and digits that say nothing.
  std::string name() const;
};

/// What was hidden, and how large it came out.
struct HiddenTruth {
  std::string cause;  // empty: a stranger
  std::string law, parameter;
  std::string joint;  // or a limb, or "robot"; empty: all
  double value = 0;   // of the parameter
  double deviation = 0;
  double size = 0;  // [SD of the measured mean] reached
  bool inverse = false, comparable = true;
  std::vector<std::string> features;
  /// Entries of the catalogue that, as large as fits best, do to the angles what this does.
  std::vector<std::string> look_alikes;
  std::string nearest;       // entry of the catalogue, a look-alike or not
  double nearest_apart = 0;  // [SD of the measured mean]
};

/// What a set holds and its diagnosis must not see.
struct Truth {
  std::string name;
  Kind kind = Kind::ExactNull;
  std::string level = "joint";  // of the diagnosis
  std::string scene = "hung_up";
  std::vector<std::string> joints;
  std::vector<HiddenTruth> hidden;
  Spoil spoil = Spoil::None;
  double torque_sd = 0, torque_time = 0, start_sd = 0;  // [N m], [s], [s]
  bool imitated = false;  // a stranger that an entry of the catalogue imitates: not to be judged
  bool fell = false;      // in a run that was recorded
  std::string shortfall;  // why a wished size could not be reached; empty: it was
};

std::string toJson(const Truth& truth);

}  // namespace nao::hidden
