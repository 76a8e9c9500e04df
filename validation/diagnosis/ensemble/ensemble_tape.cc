#include "validation/diagnosis/ensemble/ensemble_tape.h"

#include <cstdint>
#include <cstring>

namespace nao::validation {

// bytes: for every result its runs and its count (8 bytes each), then its doubles as this machine
// writes them.

EnsembleTape::EnsembleTape(const std::string& bytes) {
  std::size_t at = 0;
  std::uint64_t head[2];
  while (at + sizeof head <= bytes.size()) {
    std::memcpy(head, bytes.data() + at, sizeof head);
    at += sizeof head;
    if (head[1] > (bytes.size() - at) / sizeof(double)) break;
    Result result{static_cast<long>(head[0]), Eigen::VectorXd(static_cast<Eigen::Index>(head[1]))};
    std::memcpy(result.values.data(), bytes.data() + at, head[1] * sizeof(double));
    at += head[1] * sizeof(double);
    results_.push_back(std::move(result));
  }
}

Eigen::VectorXd EnsembleTape::next(long& used, const std::function<Eigen::VectorXd()>& simulate) {
  if (played_ < results_.size()) {
    used += results_[played_].runs;
    return results_[played_++].values;
  }
  const long before = used;
  results_.push_back({0, simulate()});
  results_.back().runs = used - before;
  return results_[played_++].values;
}

std::string EnsembleTape::bytes() const {
  std::string bytes;
  for (const Result& result : results_) {
    const std::uint64_t head[2] = {static_cast<std::uint64_t>(result.runs),
                                   static_cast<std::uint64_t>(result.values.size())};
    bytes.append(reinterpret_cast<const char*>(head), sizeof head);
    bytes.append(reinterpret_cast<const char*>(result.values.data()), head[1] * sizeof(double));
  }
  return bytes;
}

}  // namespace nao::validation
