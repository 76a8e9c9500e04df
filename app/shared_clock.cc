#include "app/shared_clock.h"

#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <new>

#include "clock/futex.h"
#include "core/check.h"
#include "daemon/epoch.h"

namespace nao::app {

SharedClock::SharedClock(clock::Mode mode) {
  file_ = ::memfd_create("usarnaoqi-clock", MFD_CLOEXEC);
  if (file_ < 0 || ::ftruncate(file_, sizeof(clock::ClockPage)) != 0)
    throw InputError("run: the system gives no memory to share");
  void* at =
      ::mmap(nullptr, sizeof(clock::ClockPage), PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
  if (at == MAP_FAILED) throw InputError("run: the system gives no memory to share");
  page_ = new (at) clock::ClockPage{};
  page_->mode = mode;
  page_->epoch = std::chrono::nanoseconds(daemon::kEpoch).count();
  page_->speed = 1;
  page_->holder = clock::kWorld;
  page_->magic = clock::kMagic;
}

SharedClock::~SharedClock() {
  ::munmap(page_, sizeof(clock::ClockPage));
  ::close(file_);
}

std::string SharedClock::path() const {
  return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file_);
}

void SharedClock::stop() {
  const std::chrono::nanoseconds now = std::chrono::steady_clock::now().time_since_epoch();
  page_->stopped = now.count();
  clock::ring(page_->beat);
  for (clock::Slot& slot : page_->slots) clock::ring(slot.bell);
}

std::string clockLibrary() {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::path library =
      fs::read_symlink("/proc/self/exe", unknown).parent_path() / "libusarnaoqi_clock.so";
  if (!fs::exists(library))
    throw InputError(library.string() + ": is missing, expected beside usarnaoqi");
  return library.string();
}

}  // namespace nao::app
