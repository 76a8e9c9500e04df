"""The numbers of ALVideoDevice, under the names client programs use."""

kTopCamera, kBottomCamera = 0, 1

# Resolutions: 160x120, 320x240, 640x480, 1280x960, 2560x1920; then 80x60, 40x30.
kQQVGA, kQVGA, kVGA, k4VGA, k16VGA = 0, 1, 2, 3, 4
kQQQVGA, kQQQQVGA = 7, 8

# Colour spaces. Of one layer: the capital letter is the channel that is kept.
kYuvColorSpace, kyUvColorSpace, kyuVColorSpace = 0, 1, 2
kRgbColorSpace, krGbColorSpace, krgBColorSpace = 3, 4, 5
kHsyColorSpace, khSyColorSpace, khsYColorSpace = 6, 7, 8
kYUV422ColorSpace, kYUVColorSpace, kRGBColorSpace, kHSYColorSpace = 9, 10, 11, 12
kBGRColorSpace, kYYCbCrColorSpace, kH2RGBColorSpace, kHSMixedColorSpace = 13, 14, 15, 16

# Parameters.
kCameraBrightnessID, kCameraContrastID, kCameraSaturationID, kCameraHueID = 0, 1, 2, 3
kCameraRedChromaID, kCameraBlueChromaID, kCameraGainID = 4, 5, 6
kCameraHFlipID, kCameraVFlipID, kCameraLensXID, kCameraLensYID = 7, 8, 9, 10
kCameraAutoExpositionID, kCameraAutoWhiteBalanceID, kCameraAutoGainID = 11, 12, 13
kCameraResolutionID, kCameraFrameRateID, kCameraBufferSizeID = 14, 15, 16
kCameraExposureID, kCameraSelectID, kCameraSetDefaultParamsID = 17, 18, 19
kCameraColorSpaceID, kCameraExposureCorrectionID, kCameraExposureAlgorithmID = 20, 21, 22
kCameraFastSwitchID, kCameraSharpnessID, kCameraAwbGreenGainID = 23, 24, 25
kCameraWhiteBalanceID, kCameraBacklightCompensationID, kCameraKeepAliveID = 33, 34, 35
