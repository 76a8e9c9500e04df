#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace nao::daemon {

/// Reads a ring of pictures as docs/lola.md describes it, and knows no more.
class PictureRingReader {
 public:
  struct Picture {
    std::uint64_t number = 0;  // from 1
    std::uint64_t time = 0;    // [ns]
    std::uint32_t camera = 0;
    std::vector<std::uint8_t> pixels;
  };

  explicit PictureRingReader(const std::string& name) {
    const int file = ::shm_open(("/" + name).c_str(), O_RDONLY, 0);
    struct stat about {};
    if (file < 0 || ::fstat(file, &about) != 0) throw std::runtime_error("no ring " + name);
    size_ = static_cast<std::size_t>(about.st_size);
    void* memory = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, file, 0);
    ::close(file);
    if (memory == MAP_FAILED) throw std::runtime_error("no memory of ring " + name);
    memory_ = static_cast<const std::uint8_t*>(memory);
    if (std::memcmp(memory_, "usarring", 8) != 0 || number<std::uint32_t>(8) != 1) {
      throw std::runtime_error(name + " is no ring");
    }
  }
  ~PictureRingReader() { ::munmap(const_cast<std::uint8_t*>(memory_), size_); }
  PictureRingReader(const PictureRingReader&) = delete;
  PictureRingReader& operator=(const PictureRingReader&) = delete;

  std::uint32_t slots() const { return number<std::uint32_t>(12); }
  std::uint32_t width() const { return number<std::uint32_t>(20); }
  std::uint32_t height() const { return number<std::uint32_t>(24); }
  std::uint64_t newest() const { return shared(32); }

  /// That picture, unless another one is in its place.
  std::optional<Picture> read(std::uint64_t wanted) const {
    const std::size_t slot = 64 + (wanted - 1) % slots() * number<std::uint32_t>(16);
    const std::uint64_t state = shared(slot);
    if (wanted == 0 || state != 2 * wanted) return std::nullopt;
    Picture picture{wanted, number<std::uint64_t>(slot + 8), number<std::uint32_t>(slot + 16), {}};
    const std::size_t bytes = std::size_t{width()} * height() * number<std::uint32_t>(28);
    picture.pixels.assign(memory_ + slot + 64, memory_ + slot + 64 + bytes);
    __atomic_thread_fence(__ATOMIC_ACQUIRE);
    if (shared(slot) != state) return std::nullopt;
    return picture;
  }

 private:
  template <class T>
  T number(std::size_t at) const {
    T value{};
    std::memcpy(&value, memory_ + at, sizeof value);
    return value;
  }
  std::uint64_t shared(std::size_t at) const {
    return __atomic_load_n(reinterpret_cast<const std::uint64_t*>(memory_ + at), __ATOMIC_ACQUIRE);
  }

  std::size_t size_ = 0;
  const std::uint8_t* memory_ = nullptr;
};

}  // namespace nao::daemon
