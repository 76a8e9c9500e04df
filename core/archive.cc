#include "core/archive.h"

namespace nao {

void Archive::bytes(void* data, std::size_t size) {
  if (size == 0) return;
  auto* const first = static_cast<unsigned char*>(data);
  switch (mode_) {
    case Mode::Save:
      target_->insert(target_->end(), first, first + size);
      return;
    case Mode::Load:
      NAO_CHECK(position_ + size <= source_->size());
      std::memcpy(data, source_->data() + position_, size);
      position_ += size;
      return;
    case Mode::Hash:  // FNV-1a
      for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ first[i]) * 1099511628211ULL;
      return;
  }
}

}  // namespace nao
