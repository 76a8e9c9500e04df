#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao::hidden {

/// One way to hide a cause: the law that acts, and the number that is scaled to the wanted size.
struct Hideout {
  std::string cause;      // as a diagnosis should call it; empty: no entry of the catalogue
  std::string law;        // of hiddenEffects()
  std::string parameter;  // of the law, that carries the size
  double neutral = 0;     // at which it does nothing
  double start = 0;       // a deviation from neutral to begin the scaling with
  double most = 0;        // the largest deviation, of the sign of `start`
  /// Smaller deviations matter to nobody and are never named; found from the cause's effect if 0.
  double least = 0;
  std::map<std::string, double> shape;  // further parameters of the law
  bool whole_robot = false;             // acts on all joints
  bool inverse = false;                 // parameter = 1 / deviation
  bool comparable = true;               // the law's number means what the cause's does
  std::vector<std::string> features;    // of strangers: words of a right signature
  std::vector<std::string> places;      // of limb and robot sets: joints, limbs or "robot"
  std::vector<std::string> columns;     // that show its size; none: the angles of all joints
  std::string needs;                    // part of the name of the joints where it can act
};

/// The simulator's own laws: one or more hideouts of every cause that a joint can show.
std::vector<Hideout> catalogueHideouts();
/// The same causes by the laws of tests/hidden/laws.
std::vector<Hideout> likenessHideouts();
/// Causes that no entry of the catalogue stands for.
std::vector<Hideout> strangerHideouts();
/// Causes of the catalogue by MuJoCo's laws and those of its motors: names count, numbers do not.
std::vector<Hideout> mujocoHideouts();

/// Causes that a limb shows, and a robot on its feet, by the simulator's laws and those of
/// tests/hidden/laws; each with the places where it may hide.
std::vector<Hideout> limbHideouts();
std::vector<Hideout> robotHideouts();
/// The documented hull of the ankles, for models that do not have it (nao_h21_v33_no_hull).
Hideout hullHideout();

/// The hideout's effect at a deviation from neutral, on `joint` (a limb: on all of its joints) or
/// on the whole robot.
EffectSetting settingAt(const Hideout& hideout, double deviation, const RobotModel& model,
                        const std::string& joint);

/// One of the hideout's places, drawn from the seed.
std::string drawnPlace(const Hideout& hideout, std::uint64_t seed);

/// Causes that this robot's angles alone cannot tell apart, listed beforehand: no experiment of the
/// standard set separates them by more than 1.5 SD of the measured mean.
bool looksAlike(const std::string& cause, const std::string& other);

}  // namespace nao::hidden
