#pragma once

#include <memory>
#include <string>
#include <vector>

#include "validation/log/floor_recording.h"

namespace nao::hidden {

/// What a robot does in the runs of a set. HungUp: the standard motions; the others stand on their
/// feet, and are the thesis' own subjects but for Stand:
///   Stand    squats and sways
///   Kick     kicks with the right foot; its ankle's roll is told 10 degrees in the back swing
///   Balance  on the left leg, the right one to the side, its ankle's roll told 45 degrees
///   Walk     5 s at full speed
///   Turn     5 s on the spot at the full rate
///   Circle   9 s along a circle of 0.6 m
enum class Scene { HungUp, Stand, Kick, Balance, Walk, Turn, Circle };

/// "stand", "kick" ...
const char* nameOf(Scene scene);
/// @throws InputError for another word, with those that there are.
Scene sceneOf(const std::string& name);

/// The scene's motions with their actions; repeats, noise and seeds are left to the caller.
validation::FloorPlan planOf(Scene scene, std::shared_ptr<const RobotModel> model);

/// Of a scene of one motion: the first runs are to fit, then a fifth to select and a fifth to test.
void splitByRun(validation::LogSet& set);

}  // namespace nao::hidden
