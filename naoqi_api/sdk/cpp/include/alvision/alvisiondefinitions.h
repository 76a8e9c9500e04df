#pragma once

namespace AL {

// Which camera.
const int kTopCamera = 0;
const int kBottomCamera = 1;
const int kDepthCamera = 2;
const int kStereoCamera = 3;

// Camera models.
const int kOV7670 = 1;
const int kMT9M114 = 2;
const int kOV5640 = 3;
const int kXTION = 4;
const int kSimulator2D = 5;
const int kSimulator3D = 6;
const int kStereo = 7;
const int kOV4689 = 8;

// Their fields of view [degrees], horizontal and vertical.
const float kApertureH_OV7670 = 47.8f;
const float kApertureV_OV7670 = 36.8f;
const float kApertureH_MT9M114 = 60.9f;
const float kApertureV_MT9M114 = 47.6f;

// Sizes of images.
const int kQQVGA = 0;  // 160 x 120
const int kQVGA = 1;   // 320 x 240
const int kVGA = 2;    // 640 x 480
const int k4VGA = 3;   // 1280 x 960
const int k960p = k4VGA;
const int k16VGA = 4;  // 2560 x 1920
const int k1920p = k16VGA;
const int k720p = 5;         // 1280 x 720
const int k1080p = 6;        // 1920 x 1080
const int kQQQVGA = 7;       // 80 x 60
const int kQQQQVGA = 8;      // 40 x 30
const int kQ720p = 9;        // 640 x 360
const int kQQ720p = 10;      // 320 x 180
const int kQQQ720p = 11;     // 160 x 90
const int kQQQQ720p = 12;    // 80 x 45
const int k720px2 = 13;      // 2560 x 720
const int kQ720px2 = 14;     // 1280 x 360
const int kQQ720px2 = 15;    // 640 x 180
const int kQQQ720px2 = 16;   // 320 x 90
const int kQQQQ720px2 = 17;  // 160 x 45

// Colour spaces.
const int kYuvColorSpace = 0;
const int kyUvColorSpace = 1;
const int kyuVColorSpace = 2;
const int kRgbColorSpace = 3;
const int krGbColorSpace = 4;
const int krgBColorSpace = 5;
const int kHsyColorSpace = 6;
const int khSyColorSpace = 7;
const int khsYColorSpace = 8;
const int kYUV422ColorSpace = 9;
const int kYUV422InterlacedColorSpace = kYUV422ColorSpace;
const int kYUVColorSpace = 10;
const int kRGBColorSpace = 11;
const int kHSYColorSpace = 12;
const int kBGRColorSpace = 13;
const int kYYCbCrColorSpace = 14;
const int kH2RGBColorSpace = 15;
const int kHSMixedColorSpace = 16;
const int kDepthColorSpace = 17;
const int kARGBColorSpace = 18;
const int kXYZColorSpace = 19;
const int kInfraredColorSpace = 20;
const int kDistanceColorSpace = 21;
const int kLabColorSpace = 22;
const int kRawDepthColorSpace = 23;
const int kLuvColorSpace = 24;
const int kLChabColorSpace = 25;
const int kLChuvColorSpace = 26;

// A camera's parameters.
const int kCameraBrightnessID = 0;
const int kCameraContrastID = 1;
const int kCameraSaturationID = 2;
const int kCameraHueID = 3;
const int kCameraRedChromaID = 4;
const int kCameraBlueChromaID = 5;
const int kCameraGainID = 6;
const int kCameraHFlipID = 7;
const int kCameraVFlipID = 8;
const int kCameraLensXID = 9;
const int kCameraLensYID = 10;
const int kCameraAutoExpositionID = 11;
const int kCameraAutoWhiteBalanceID = 12;
const int kCameraAutoGainID = 13;
const int kCameraResolutionID = 14;
const int kCameraFrameRateID = 15;
const int kCameraBufferSizeID = 16;
const int kCameraExposureID = 17;
const int kCameraSelectID = 18;
const int kCameraSetDefaultParamsID = 19;
const int kCameraColorSpaceID = 20;
const int kCameraExposureCorrectionID = 21;
const int kCameraExposureAlgorithmID = 22;
const int kCameraAecAlgorithmID = kCameraExposureAlgorithmID;
const int kCameraFastSwitchID = 23;
const int kCameraSharpnessID = 24;
const int kCameraAwbGreenGainID = 25;
const int kCameraAblcID = 26;
const int kCameraAblcTargetID = 27;
const int kCameraAblcStableRangeID = 28;
const int kCameraBlcBlueID = 29;
const int kCameraBlcRedID = 30;
const int kCameraBlcGbID = 31;
const int kCameraBlcGrID = 32;
const int kCameraWhiteBalanceID = 33;
const int kCameraBacklightCompensationID = 34;
const int kCameraKeepAliveID = 35;
const int kCameraDepthConfidenceThresholdID = 36;
const int kCameraDepthFastFilterID = 37;
const int kCameraTemperatureID = 38;
const int kCameraAverageLuminanceID = 39;
const int kCameraAutoFocusID = 40;
const int kCameraSynchronisationID = 41;
const int kCameraDisparityWindowSizeID = 42;
const int kCameraFocusID = 43;
const int kCameraTestPatternID = 44;

/// Width and height [pixels] of images of a resolution; {-1, -1} if there is none of that number.
inline void setSizeFromResolution(int resolution, int& width, int& height) {
  static const int kSizes[][2] = {{160, 120},  {320, 240},   {640, 480}, {1280, 960}, {2560, 1920},
                                  {1280, 720}, {1920, 1080}, {80, 60},   {40, 30},    {640, 360},
                                  {320, 180},  {160, 90},    {80, 45},   {2560, 720}, {1280, 360},
                                  {640, 180},  {320, 90},    {160, 45}};
  const int count = static_cast<int>(sizeof kSizes / sizeof kSizes[0]);
  const bool known = resolution >= 0 && resolution < count;
  width = known ? kSizes[resolution][0] : -1;
  height = known ? kSizes[resolution][1] : -1;
}

/// The resolution of that size; -1 if there is none.
inline int getResolutionFromSize(int width, int height) {
  for (int resolution = 0; resolution <= kQQQQ720px2; ++resolution) {
    int its_width = 0;
    int its_height = 0;
    setSizeFromResolution(resolution, its_width, its_height);
    if (its_width == width && its_height == height) return resolution;
  }
  return -1;
}

inline bool isResolutionValid(int resolution) {
  return resolution >= kQQVGA && resolution <= kQQQQ720px2;
}

inline bool isColorSpaceValid(int space) {
  return space >= kYuvColorSpace && space <= kLChuvColorSpace;
}

/// Channels of a pixel, however many bytes each of them has; -1 for a space whose are not known.
inline int getNumChannelsInColorSpace(int space) {
  static const int kChannels[] = {1, 1, 1, 1, 1, 1, 1, 1, 1,  2, 3,  3,  3, 3,
                                  2, 3, 3, 1, 4, 3, 1, 1, -1, 1, -1, -1, -1};
  return isColorSpaceValid(space) ? kChannels[space] : -1;
}

/// Bytes of a pixel, which an image's third field counts; -1 for a space whose are not known.
inline int getNumLayersInColorSpace(int space) {
  switch (space) {
    case kDepthColorSpace:
    case kInfraredColorSpace:
    case kDistanceColorSpace:
    case kRawDepthColorSpace:
      return 2;  // of one channel
    case kXYZColorSpace:
      return 12;  // of three floats
    default:
      return getNumChannelsInColorSpace(space);
  }
}

/// The share of an image's width or height that an angle has, where its border angles are `low` and
/// `high`; all [rad].
inline float convertAngleValToNormalizedImgVal(const float& angle, const float& low,
                                               const float& high) {
  return angle / (high - low);
}
/// Where in the image a direction is: 0 at `low`, 1 at `high`; all [rad].
inline float convertAnglePosToNormalizedImgPos(const float& angle, const float& low,
                                               const float& high) {
  return (angle - low) / (high - low);
}

}  // namespace AL
