"""The numbers of ALVideoDevice, under the names client programs use."""

kTopCamera, kBottomCamera, kDepthCamera, kStereoCamera = 0, 1, 2, 3

# Camera models, and fields of view [degrees].
kOV7670, kMT9M114, kOV5640, kXTION, kSimulator2D, kSimulator3D, kStereo, kOV4689 = range(1, 9)
kApertureH_OV7670, kApertureV_OV7670 = 47.8, 36.8
kApertureH_MT9M114, kApertureV_MT9M114 = 60.9, 47.6

# Resolutions: 160x120, 320x240, 640x480, 1280x960, 2560x1920; 1280x720, 1920x1080; 80x60, 40x30;
# halves of 1280x720, which are 640x360 to 80x45; and two such pictures side by side.
kQQVGA, kQVGA, kVGA, k4VGA, k16VGA = 0, 1, 2, 3, 4
k960p, k1920p = k4VGA, k16VGA
k720p, k1080p = 5, 6
kQQQVGA, kQQQQVGA = 7, 8
kQ720p, kQQ720p, kQQQ720p, kQQQQ720p = 9, 10, 11, 12
k720px2, kQ720px2, kQQ720px2, kQQQ720px2, kQQQQ720px2 = 13, 14, 15, 16, 17

# Colour spaces. Of one layer: the capital letter is the channel that is kept.
kYuvColorSpace, kyUvColorSpace, kyuVColorSpace = 0, 1, 2
kRgbColorSpace, krGbColorSpace, krgBColorSpace = 3, 4, 5
kHsyColorSpace, khSyColorSpace, khsYColorSpace = 6, 7, 8
kYUV422ColorSpace, kYUVColorSpace, kRGBColorSpace, kHSYColorSpace = 9, 10, 11, 12
kYUV422InterlacedColorSpace = kYUV422ColorSpace
kBGRColorSpace, kYYCbCrColorSpace, kH2RGBColorSpace, kHSMixedColorSpace = 13, 14, 15, 16
kDepthColorSpace, kARGBColorSpace, kXYZColorSpace = 17, 18, 19
kInfraredColorSpace, kDistanceColorSpace, kLabColorSpace, kRawDepthColorSpace = 20, 21, 22, 23
kLuvColorSpace, kLChabColorSpace, kLChuvColorSpace = 24, 25, 26

# Parameters.
kCameraBrightnessID, kCameraContrastID, kCameraSaturationID, kCameraHueID = 0, 1, 2, 3
kCameraRedChromaID, kCameraBlueChromaID, kCameraGainID = 4, 5, 6
kCameraHFlipID, kCameraVFlipID, kCameraLensXID, kCameraLensYID = 7, 8, 9, 10
kCameraAutoExpositionID, kCameraAutoWhiteBalanceID, kCameraAutoGainID = 11, 12, 13
kCameraResolutionID, kCameraFrameRateID, kCameraBufferSizeID = 14, 15, 16
kCameraExposureID, kCameraSelectID, kCameraSetDefaultParamsID = 17, 18, 19
kCameraColorSpaceID, kCameraExposureCorrectionID, kCameraExposureAlgorithmID = 20, 21, 22
kCameraAecAlgorithmID = kCameraExposureAlgorithmID
kCameraFastSwitchID, kCameraSharpnessID, kCameraAwbGreenGainID = 23, 24, 25
kCameraAblcID, kCameraAblcTargetID, kCameraAblcStableRangeID = 26, 27, 28
kCameraBlcBlueID, kCameraBlcRedID, kCameraBlcGbID, kCameraBlcGrID = 29, 30, 31, 32
kCameraWhiteBalanceID, kCameraBacklightCompensationID, kCameraKeepAliveID = 33, 34, 35
kCameraDepthConfidenceThresholdID, kCameraDepthFastFilterID, kCameraTemperatureID = 36, 37, 38
kCameraAverageLuminanceID, kCameraAutoFocusID, kCameraSynchronisationID = 39, 40, 41
kCameraDisparityWindowSizeID, kCameraFocusID, kCameraTestPatternID = 42, 43, 44
