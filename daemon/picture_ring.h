#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "camera/image.h"

namespace nao::daemon {

/// The newest pictures of a camera in shared memory, for any number of readers that never make the
/// writer wait. Little endian, no padding beside what is listed:
///
///   ring     = header, slot[slots]
///   header   64 bytes: "usarring" 8, version u32 = 1, slots u32, slot size u32, width u32,
///            height u32, bytes per pixel u32, newest u64: how many pictures there ever were; rest
///            0
///   slot     64 bytes and the pixels, rows from the top: state u64, time u64 [simulated ns],
///            camera u32 (0 top, 1 bottom), rest 0; a slot's size is a multiple of 64
///
/// Picture n, counted from 1, is in slot (n - 1) % slots while that slot's state is 2 n; while it
/// is written the state is odd. A reader reads `newest`, copies that picture, and looks at the
/// state again: if it is not what it was, it begins anew.
class PictureRing {
 public:
  static constexpr std::uint32_t kSlots = 8;  // a quarter of a second at 30 pictures a second
  static constexpr std::size_t kHeader = 64;  // bytes, of the ring and of a slot

  /// Makes shared memory of this name (/dev/shm/NAME) for pictures of one size and kind.
  /// @throws InputError if another program writes pictures there, or it can not be made.
  PictureRing(const std::string& name, camera::ImageSize size, camera::ColorSpace space);
  ~PictureRing();
  PictureRing(const PictureRing&) = delete;
  PictureRing& operator=(const PictureRing&) = delete;

  /// `image` is of the ring's size and kind.
  void write(const camera::Image& image, std::uint32_t camera);

 private:
  std::uint8_t* slot(std::uint64_t picture) const;

  std::string name_;
  std::size_t pixels_;     // bytes
  std::size_t slot_size_;  // bytes
  std::size_t size_;       // bytes
  int descriptor_ = -1;
  std::uint8_t* memory_ = nullptr;
  std::uint64_t newest_ = 0;
};

}  // namespace nao::daemon
