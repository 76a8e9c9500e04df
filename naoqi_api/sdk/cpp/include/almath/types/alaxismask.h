#pragma once

#include <bitset>

namespace AL {
namespace Math {

/// Which of an effector's six axes a motion controls: bits of x, y, z, wx, wy, wz, x the lowest.
typedef std::bitset<6> AXIS_MASK;

static const int AXIS_MASK_NONE = 0;
static const int AXIS_MASK_X = 1;
static const int AXIS_MASK_Y = 2;
static const int AXIS_MASK_XY = 3;
static const int AXIS_MASK_Z = 4;
static const int AXIS_MASK_VEL = 7;  // x, y, z
static const int AXIS_MASK_WX = 8;
static const int AXIS_MASK_WY = 16;
static const int AXIS_MASK_WZ = 32;
static const int AXIS_MASK_WYWZ = 48;
static const int AXIS_MASK_ROT = 56;  // wx, wy, wz
static const int AXIS_MASK_ALL = 63;

}  // namespace Math
}  // namespace AL
