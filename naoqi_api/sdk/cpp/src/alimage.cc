#include <alvision/alimage.h>

#include <fstream>
#include <sstream>

namespace AL {
namespace {

enum Field { kWidth, kHeight, kLayers, kSpace, kSeconds, kMicroseconds, kData, kCamera, kAngles };
constexpr unsigned int kFields = kData + 1;  // what every NaoQi sends

int sizeOf(int resolution, bool of_height) {
  int width = 0, height = 0;
  setSizeFromResolution(resolution, width, height);
  return of_height ? height : width;
}

template <class T>
T fieldOr(const ALValue& image, int index, T missing) {
  return index < static_cast<int>(image.getSize()) ? static_cast<T>(image[index]) : missing;
}

}  // namespace

ALImage::ALImage(int width, int height, int color_space, bool is_external, float left_angle,
                 float top_angle, float right_angle, float bottom_angle)
    : width_(width),
      height_(height),
      color_space_(color_space),
      layers_(getNumLayersInColorSpace(color_space)),
      max_resolution_(getResolutionFromSize(width, height)),
      max_layers_(layers_),
      is_external_(is_external) {
  if (width < 0 || height < 0 || layers_ < 0) {
    throw ALERROR("ALImage", "ALImage", "expected a size and a colour space, found " + toString());
  }
  setAngles(left_angle, top_angle, right_angle, bottom_angle);
  if (!is_external) own_.resize(neededSize());
}

ALImage::ALImage(int resolution, int color_space, bool is_external, float left_angle,
                 float top_angle, float right_angle, float bottom_angle)
    : ALImage(sizeOf(resolution, false), sizeOf(resolution, true), color_space, is_external,
              left_angle, top_angle, right_angle, bottom_angle) {}

ALImage::ALImage(const ALValue& image) {
  if (!image.isArray() || image.getSize() < kFields || !image[kData].isBinary()) {
    throw ALERROR("ALImage", "ALImage", "expected an image, found " + image.toString());
  }
  width_ = image[kWidth];
  height_ = image[kHeight];
  layers_ = max_layers_ = image[kLayers];
  color_space_ = image[kSpace];
  max_resolution_ = getResolution();
  setTimeStamp(static_cast<int>(image[kSeconds]), static_cast<int>(image[kMicroseconds]));
  lent_ = image[kData];
  camera_ = static_cast<char>(fieldOr(image, kCamera, 0));
  setAngles(fieldOr(image, kAngles, 0.0F), fieldOr(image, kAngles + 1, 0.0F),
            fieldOr(image, kAngles + 2, 0.0F), fieldOr(image, kAngles + 3, 0.0F));
}

ALImage ALImage::deepCopy() const {
  ALImage copy = *this;
  const unsigned char* const first = pixels();
  if (first != nullptr) copy.own_.assign(first, first + getSize());
  copy.is_external_ = false;
  copy.external_ = nullptr;
  copy.lent_.clear();
  return copy;
}

ALImage* ALImage::fromALValue(const ALValue& image) {
  try {
    return std::make_unique<ALImage>(ALImage(image).deepCopy()).release();
  } catch (const ALError&) {
    return nullptr;
  }
}

ALValue ALImage::toALValue() const {
  const ALValue bytes(static_cast<const void*>(pixels()),
                      pixels() != nullptr ? static_cast<int>(getSize()) : 0);
  return ALValue::array(width_, height_, layers_, color_space_, getTimeStampS(), getTimeStampUS(),
                        bytes, static_cast<int>(camera_), left_angle_, top_angle_, right_angle_,
                        bottom_angle_);
}

bool ALImage::setResolution(int resolution) {
  const int width = sizeOf(resolution, false), height = sizeOf(resolution, true);
  if (!isResolutionValid(resolution) || !hasRoomFor(width, height, layers_)) return false;
  width_ = width;
  height_ = height;
  return true;
}

bool ALImage::setColorSpace(int color_space) {
  const int layers = getNumLayersInColorSpace(color_space);
  if (layers < 0 || !hasRoomFor(width_, height_, layers)) return false;
  color_space_ = color_space;
  layers_ = layers;
  return true;
}

bool ALImage::hasRoomFor(long long width, long long height, long long layers) const {
  return is_external_ || width * height * layers <= getSize();
}

void ALImage::setData(unsigned char* pixels) {
  external_ = pixels;
  is_external_ = true;
  lent_.clear();
  own_.clear();
}

unsigned char* ALImage::pixels() const {
  if (is_external_) return external_;
  if (lent_.isBinary()) return static_cast<unsigned char*>(const_cast<void*>(lent_.GetBinary()));
  return const_cast<unsigned char*>(own_.data());
}

unsigned int ALImage::getSize() const {
  if (is_external_) return neededSize();
  return lent_.isBinary() ? lent_.getSize() : static_cast<unsigned int>(own_.size());
}

unsigned int ALImage::neededSize() const {
  return static_cast<unsigned int>(width_) * static_cast<unsigned int>(height_) *
         static_cast<unsigned int>(layers_);
}

void ALImage::getAngles(float& left, float& top, float& right, float& bottom) const {
  left = left_angle_;
  top = top_angle_;
  right = right_angle_;
  bottom = bottom_angle_;
}

void ALImage::setAngles(float left, float top, float right, float bottom) {
  left_angle_ = left;
  top_angle_ = top;
  right_angle_ = right;
  bottom_angle_ = bottom;
}

const ALImage::ROI* ALImage::getROI(int index) const {
  const bool is_there = index >= 0 && index < getNumOfROIs();
  return is_there ? &rois_[static_cast<std::size_t>(index)] : nullptr;
}

std::string ALImage::toString() const {
  std::ostringstream text;
  text << width_ << " x " << height_ << " pixels of colour space " << color_space_ << " at "
       << time_us_ << " us";
  return text.str();
}

int ALImage::savePPM(const char* path) const {
  const bool is_gray = layers_ == 1;
  const bool is_bgr = color_space_ == kBGRColorSpace && layers_ == 3;
  const bool is_rgb = color_space_ == kRGBColorSpace && layers_ == 3;
  if (!(is_gray || is_bgr || is_rgb) || pixels() == nullptr || getSize() < neededSize()) return -1;
  const int red = is_bgr ? 2 : 0, green = is_gray ? 0 : 1, blue = is_rgb ? 2 : 0;
  std::string colors;
  for (unsigned int i = 0; i < neededSize(); i += static_cast<unsigned int>(layers_)) {
    for (const int layer : {red, green, blue}) colors += static_cast<char>(pixels()[i + layer]);
  }
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << width_ << ' ' << height_ << "\n255\n" << colors << std::flush;
  return file ? 0 : -1;
}

}  // namespace AL
