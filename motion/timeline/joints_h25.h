#pragma once

#include <array>

namespace nao::motion {

/// The 26 joints in the order of the teams whose tables go head, arms, legs (reference: the header
/// lines of their files).
inline constexpr std::array<const char*, 26> kHeadArmsLegs = {
    "HeadYaw",        "HeadPitch",  //
    "LShoulderPitch", "LShoulderRoll", "LElbowYaw", "LElbowRoll", "LWristYaw",   "LHand",
    "RShoulderPitch", "RShoulderRoll", "RElbowYaw", "RElbowRoll", "RWristYaw",   "RHand",
    "LHipYawPitch",   "LHipRoll",      "LHipPitch", "LKneePitch", "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",   "RHipRoll",      "RHipPitch", "RKneePitch", "RAnklePitch", "RAnkleRoll"};

}  // namespace nao::motion
