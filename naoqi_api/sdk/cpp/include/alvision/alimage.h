#pragma once

#include <memory>
#include <string>
#include <vector>

#include <alerror/alerror.h>
#include <alvalue/alvalue.h>
#include <alvision/alvisiondefinitions.h>
#include <usarnaoqi_sdk/export.h>
#include <qi/os.hpp>

namespace AL {

/// A camera's image: pixels row by row, and where and when they were seen. Its pixels are its own,
/// or someone else's: a value's, which it keeps alive, or a buffer of the program's (setData).
class USARNAOQI_SDK_API ALImage {
 public:
  /// A part of the image [pixels], and where it is seen [rad].
  struct ROI {
    ROI(int left, int top, int width, int height, float its_left_angle = 0, float its_top_angle = 0,
        float its_right_angle = 0, float its_bottom_angle = 0)
        : x(left),
          y(top),
          w(width),
          h(height),
          leftAngle(its_left_angle),
          topAngle(its_top_angle),
          rightAngle(its_right_angle),
          bottomAngle(its_bottom_angle) {}

    int x, y, w, h;
    float leftAngle, topAngle, rightAngle, bottomAngle;
  };

  /// Black, or without pixels until setData() if they are external. Angles are those of the image's
  /// borders [rad]. @throws ALError for a size below 0 or a colour space that is none.
  ALImage(int width, int height, int color_space, bool is_external = false, float left_angle = 0,
          float top_angle = 0, float right_angle = 0, float bottom_angle = 0);
  /// The same of a resolution's size. @throws ALError if it is none.
  ALImage(int resolution, int color_space, bool is_external = false, float left_angle = 0,
          float top_angle = 0, float right_angle = 0, float bottom_angle = 0);
  /// The fields of what ALVideoDevice returns, without a copy of the pixels.
  /// @throws ALError if it is not what getImageRemote returns.
  explicit ALImage(const ALValue& image);
  /// The same with a copy of the pixels, to be deleted; NULL if it is not what getImageRemote
  /// returns.
  static ALImage* fromALValue(const ALValue& image);
  /// The same image with pixels of its own.
  ALImage deepCopy() const;
  /// The 12 fields of what ALVideoDevice returns, the pixels as a copy.
  ALValue toALValue() const;

  int getWidth() const { return width_; }
  int getHeight() const { return height_; }
  /// -1 for a size that has none.
  int getResolution() const { return getResolutionFromSize(width_, height_); }
  int getColorSpace() const { return color_space_; }
  /// Bytes of a pixel.
  int getNbLayers() const { return layers_; }
  void setWidth(int width) { width_ = width; }
  void setHeight(int height) { height_ = height; }
  /// False, and nothing changed, if there is none of that number or no room for it.
  bool setResolution(int resolution);
  bool setSize(int resolution) { return setResolution(resolution); }
  bool setColorSpace(int color_space);
  /// What it was made with.
  int getMaxResolution() const { return max_resolution_; }
  int getNbOfLayersMax() const { return max_layers_; }

  /// NULL without pixels. A value's pixels are to be read only, whatever the type.
  const unsigned char* getData() const { return pixels(); }
  unsigned char* getData() { return pixels(); }
  const unsigned char* getFrame() const { return pixels(); }
  unsigned char* getFrame() { return pixels(); }
  /// Shows a buffer of the program's from now on, as large as the image is and as long as it.
  void setData(unsigned char* pixels);
  bool areDataExternal() const { return is_external_; }
  /// Bytes: those that the image was given, or of external ones as many as its size needs.
  unsigned int getSize() const;
  int getAllocatedSize() const { return static_cast<int>(getSize()); }

  /// Microseconds since 1970 by the robot's clock.
  long long getTimeStamp() const { return time_us_; }
  int getTimeStampS() const { return static_cast<int>(time_us_ / 1000000); }
  int getTimeStampUS() const { return static_cast<int>(time_us_ % 1000000); }
  void setTimeStamp(const qi::os::timeval time) {
    time_us_ = static_cast<long long>(time.tv_sec) * 1000000 + time.tv_usec;
  }
  void setTimeStamp(long long microseconds) { time_us_ = microseconds; }
  void setTimeStamp(int seconds, int microseconds) {
    time_us_ = static_cast<long long>(seconds) * 1000000 + microseconds;
  }
  /// 0: top, 1: bottom.
  char getCameraId() const { return camera_; }
  void setCameraId(char camera) { camera_ = camera; }

  /// The directions of the borders [rad].
  float getLeftAngle() const { return left_angle_; }
  float getTopAngle() const { return top_angle_; }
  float getRightAngle() const { return right_angle_; }
  float getBottomAngle() const { return bottom_angle_; }
  void getAngles(float& left, float& top, float& right, float& bottom) const;
  void setLeftAngle(float angle) { left_angle_ = angle; }
  void setTopAngle(float angle) { top_angle_ = angle; }
  void setRightAngle(float angle) { right_angle_ = angle; }
  void setBottomAngle(float angle) { bottom_angle_ = angle; }
  void setAngles(float left, float top, float right, float bottom);

  int getNumOfROIs() const { return static_cast<int>(rois_.size()); }
  /// NULL for a number that none has.
  const ROI* getROI(int index) const;
  void addROI(const ROI& part) { rois_.push_back(part); }
  void cleanROIs() { rois_.clear(); }
  /// Whether the parts are to be used; says nothing to this class.
  void setEnableROIs(bool enable) { rois_enabled_ = enable; }
  bool isROIEnabled() const { return rois_enabled_; }

  /// Size, colour space and time, for people.
  std::string toString() const;
  /// Writes a PPM file, of RGB, BGR or one layer. 0; -1 of any other, or if it can not be written.
  int savePPM(const char* path) const;

 private:
  unsigned char* pixels() const;
  unsigned int neededSize() const;
  bool hasRoomFor(long long width, long long height, long long layers) const;

  int width_ = 0;
  int height_ = 0;
  int color_space_ = 0;
  int layers_ = 0;
  int max_resolution_ = -1;
  int max_layers_ = 0;
  long long time_us_ = 0;
  char camera_ = 0;
  float left_angle_ = 0;
  float top_angle_ = 0;
  float right_angle_ = 0;
  float bottom_angle_ = 0;
  std::vector<ROI> rois_;
  bool rois_enabled_ = false;

  bool is_external_ = false;
  unsigned char* external_ = nullptr;
  ALValue lent_;  // bytes, or none
  std::vector<unsigned char> own_;
};

}  // namespace AL
