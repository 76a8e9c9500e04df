#pragma once

#include <unistd.h>

#include <exception>
#include <stdexcept>

namespace nao {

/// Who is root reads what nobody may: as long as this lives, the process is somebody else.
class Unprivileged {
 public:
  Unprivileged() : before_(::geteuid()) {
    if (before_ == 0 && ::seteuid(kNobody) != 0) throw std::runtime_error("seteuid refused");
  }
  ~Unprivileged() {
    if (before_ == 0 && ::seteuid(0) != 0) std::terminate();
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  uid_t before_;
};

}  // namespace nao
