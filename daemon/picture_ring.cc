#include "daemon/picture_ring.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstring>

#include "core/check.h"

namespace nao::daemon {
namespace {

constexpr std::size_t kNewestAt = 32;  // in the header
constexpr std::size_t kTimeAt = 8;     // in a slot
constexpr std::size_t kCameraAt = 16;

void put(std::uint8_t* at, std::uint32_t number) { std::memcpy(at, &number, sizeof number); }

// Readers see what was written before, once they see this.
void publish(std::uint8_t* at, std::uint64_t number) {
  __atomic_store_n(reinterpret_cast<std::uint64_t*>(at), number, __ATOMIC_RELEASE);
}

// Memory that a killed program left has no lock; its readers keep what they have.
int openOwn(const std::string& name) {
  for (;;) {
    const int file = ::shm_open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0) return -1;
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      ::close(file);
      return -1;
    }
    if (::lseek(file, 0, SEEK_END) == 0) return file;
    ::shm_unlink(name.c_str());
    ::close(file);
  }
}

}  // namespace

PictureRing::PictureRing(const std::string& name, camera::ImageSize size, camera::ColorSpace space)
    : name_("/" + name),
      pixels_(static_cast<std::size_t>(size.width * size.height * camera::layers(space))),
      slot_size_((kHeader + pixels_ + 63) / 64 * 64),
      size_(kHeader + kSlots * slot_size_),
      descriptor_(openOwn(name_)) {
  const bool sized = descriptor_ >= 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0;
  void* memory = sized ? ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0)
                       : MAP_FAILED;
  if (memory == MAP_FAILED) {
    if (descriptor_ >= 0) ::close(descriptor_);
    throw InputError("shared memory " + name_ + ": another program has it, or it can not be made");
  }
  memory_ = static_cast<std::uint8_t*>(memory);
  const auto numbers = {1U,
                        kSlots,
                        static_cast<std::uint32_t>(slot_size_),
                        static_cast<std::uint32_t>(size.width),
                        static_cast<std::uint32_t>(size.height),
                        static_cast<std::uint32_t>(camera::layers(space))};
  std::uint8_t* at = memory_ + 8;
  for (const std::uint32_t number : numbers) {
    put(at, number);
    at += sizeof number;
  }
  std::memcpy(memory_, "usarring", 8);
}

PictureRing::~PictureRing() {
  ::shm_unlink(name_.c_str());
  ::munmap(memory_, size_);
  ::close(descriptor_);
}

std::uint8_t* PictureRing::slot(std::uint64_t picture) const {
  return memory_ + kHeader + (picture - 1) % kSlots * slot_size_;
}

void PictureRing::write(const camera::Image& image, std::uint32_t camera) {
  NAO_CHECK(image.bytes->size() == pixels_);
  std::uint8_t* to = slot(++newest_);
  publish(to, 2 * newest_ - 1);
  std::atomic_thread_fence(std::memory_order_seq_cst);
  const std::int64_t time = image.time.time_since_epoch().count();
  std::memcpy(to + kTimeAt, &time, sizeof time);
  put(to + kCameraAt, camera);
  std::memcpy(to + kHeader, image.bytes->data(), pixels_);
  publish(to, 2 * newest_);
  publish(memory_ + kNewestAt, newest_);
}

}  // namespace nao::daemon
