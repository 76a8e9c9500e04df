"""The numbers of ALMotion, under the names client programs use."""

from math import pi as PI

TO_RAD, TO_DEG = PI / 180, 180 / PI

# Frames: the torso; the floor where the robot woke up; the floor between its feet now.
FRAME_TORSO, FRAME_WORLD, FRAME_ROBOT = 0, 1, 2
SPACE_TORSO, SPACE_WORLD, SPACE_NAO = 0, 1, 2  # their names before NAOqi 1.12

# Which axes of an effector are controlled: a sum of these.
AXIS_MASK_X, AXIS_MASK_Y, AXIS_MASK_Z = 1, 2, 4
AXIS_MASK_WX, AXIS_MASK_WY, AXIS_MASK_WZ = 8, 16, 32
AXIS_MASK_VEL, AXIS_MASK_ROT, AXIS_MASK_ALL = 7, 56, 63

# Interpolations of the 1.x days.
INTERPOLATION_LINEAR, INTERPOLATION_SMOOTH = 0, 1

# What a leg may do while the body is balanced as a whole.
SUPPORT_MODE_LEFT, SUPPORT_MODE_DOUBLE_LEFT = 0, 1
SUPPORT_MODE_RIGHT, SUPPORT_MODE_DOUBLE_RIGHT = 2, 3
