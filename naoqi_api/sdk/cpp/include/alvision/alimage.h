#pragma once

#include <string>

#include <alerror/alerror.h>
#include <alvalue/alvalue.h>
#include <alvision/alvisiondefinitions.h>

namespace AL {

/// A camera's image: the fields of what ALVideoDevice returns. Keeps the bytes of the value it was
/// made of alive, without a copy.
class ALImage {
 public:
  /// @throws ALError if it is not what getImageRemote returns.
  explicit ALImage(const ALValue& image) : image_(image) {
    if (!image.isArray() || image.getSize() < kFields || !image[kData].isBinary()) {
      throw ALERROR("ALImage", "ALImage", "expected an image, found " + image.toString());
    }
  }
  static ALImage* fromALValue(const ALValue& image) { return new ALImage(image); }

  int getWidth() const { return image_[0]; }
  int getHeight() const { return image_[1]; }
  int getNbLayers() const { return image_[2]; }
  int getColorSpace() const { return image_[3]; }
  /// Microseconds since 1970 by the robot's clock.
  long long getTimeStamp() const {
    return static_cast<long long>(getTimeStampS()) * 1000000 + getTimeStampUS();
  }
  int getTimeStampS() const { return image_[4]; }
  int getTimeStampUS() const { return image_[5]; }
  /// The pixels, row by row. To be read only, whatever the type, which is what programs assign.
  unsigned char* getData() const {
    return static_cast<unsigned char*>(const_cast<void*>(image_[kData].GetBinary()));
  }
  int getSize() const { return static_cast<int>(image_[kData].getSize()); }
  /// 0: top, 1: bottom.
  int getCameraId() const { return field(7); }
  float getLeftAngle() const { return angle(8); }
  float getTopAngle() const { return angle(9); }
  float getRightAngle() const { return angle(10); }
  float getBottomAngle() const { return angle(11); }
  ALValue toALValue() const { return image_; }
  std::string toString() const { return image_.toString(); }

 private:
  enum { kData = 6, kFields = 7 };

  bool has(int index) const { return static_cast<unsigned int>(index) < image_.getSize(); }
  int field(int index) const { return has(index) ? static_cast<int>(image_[index]) : 0; }
  float angle(int index) const { return has(index) ? static_cast<float>(image_[index]) : 0; }

  ALValue image_;
};

}  // namespace AL
