#include "validation/diagnosis/kept_runs.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>

#include "core/check.h"
#include "validation/log/file_hash.h"

namespace nao::validation {
namespace {

// bytes: counts (8 bytes each) of lists, of the vectors of each, of the doubles of each; doubles as
// this machine writes them.
class Writer {
 public:
  void count(std::size_t number) {
    const std::uint64_t wide = number;
    bytes_.append(reinterpret_cast<const char*>(&wide), sizeof wide);
  }
  void values(const Eigen::VectorXd& values) {
    count(static_cast<std::size_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()),
                  static_cast<std::size_t>(values.size()) * sizeof(double));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  std::size_t count() {
    std::uint64_t wide = 0;
    read(&wide, sizeof wide);
    NAO_CHECK(wide <= bytes_.size());
    return static_cast<std::size_t>(wide);
  }
  Eigen::VectorXd values() {
    Eigen::VectorXd values(static_cast<Eigen::Index>(count()));
    read(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
    return values;
  }

 private:
  void read(void* to, std::size_t size) {
    NAO_CHECK(size <= bytes_.size() - at_);
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

std::string bytesOf(const WholePool& pool) {
  Writer writer;
  writer.count(pool.size());
  for (const auto& list : pool) {
    writer.count(list.size());
    for (const Eigen::VectorXd& one : list) writer.values(one);
  }
  return writer.take();
}

WholePool poolOf(const std::string& bytes) {
  Reader reader(bytes);
  WholePool pool(reader.count());
  for (auto& list : pool) {
    list.resize(reader.count());
    for (Eigen::VectorXd& one : list) one = reader.values();
  }
  return pool;
}

}  // namespace

WholePool KeptRuns::remember(const std::string& what,
                             const std::function<WholePool()>& simulate) const {
  if (!kept_.keeps()) return simulate();
  const std::string unit = sha256Of(what);
  if (const auto before = kept_.find(unit)) return poolOf(*before);
  WholePool pool = simulate();
  kept_.keep(unit, bytesOf(pool));
  return pool;
}

std::string textOf(const std::vector<EffectSetting>& effects) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  for (const EffectSetting& effect : effects) {
    text << effect.name;
    for (const Joint joint : effect.joints) text << " @" << index(joint);
    for (const auto& [name, value] : effect.parameters) text << ' ' << name << '=' << value;
    text << '\n';
  }
  return text.str();
}

}  // namespace nao::validation
