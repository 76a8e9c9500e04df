#pragma once

#include <array>

namespace nao {

/// The joints of a V6 in the order of every list of LoLA, the protocol of its body: one value for
/// both HipYawPitch, hands last. Other robots have some of them.
inline constexpr std::array kLolaJoints{
    "HeadYaw",    "HeadPitch",   "LShoulderPitch", "LShoulderRoll",  "LElbowYaw",
    "LElbowRoll", "LWristYaw",   "LHipYawPitch",   "LHipRoll",       "LHipPitch",
    "LKneePitch", "LAnklePitch", "LAnkleRoll",     "RHipRoll",       "RHipPitch",
    "RKneePitch", "RAnklePitch", "RAnkleRoll",     "RShoulderPitch", "RShoulderRoll",
    "RElbowYaw",  "RElbowRoll",  "RWristYaw",      "LHand",          "RHand"};

}  // namespace nao
