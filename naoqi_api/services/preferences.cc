#include "naoqi_api/services/preferences.h"

#include "naoqi_api/memory/value_size.h"

namespace nao::services {
namespace {

using rpc::CallError;
using rpc::Value;

constexpr std::size_t kMostBytes = 16U << 20U;  // of all values; free
constexpr std::chrono::seconds kSaveAfter{1};   // changes before that are written with it; free

std::size_t sizeOf(const std::string& domain, const std::string& key, const Value& value) {
  return domain.size() + key.size() + memory::sizeOf(value);
}

KeptLines::Line lineOf(const std::string& domain, const std::string& key, const Value& value) {
  return {{"domain", domain}, {"key", key}, {"value", value}};
}

}  // namespace

Preferences::Preferences(const ServiceContext& context, const std::string& file)
    : context_(context), file_(context.data_dir, file, "preferences") {
  load();
}

Preferences::~Preferences() { save(); }

void Preferences::load() {
  try {
    const auto lines = file_.read({"domain", "key", "value"});
    if (!lines) return;
    for (const KeptLines::Line& line : *lines) {
      put(KeptLines::find(line, "domain")->to<std::string>(),
          KeptLines::find(line, "key")->to<std::string>(), *KeptLines::find(line, "value"));
    }
  } catch (const CallError& error) {
    domains_.clear();
    bytes_ = 0;
    context_.warn(std::string(error.what()) + "; preferences begin anew, the file is now " +
                  file_.putAside());
  }
}

void Preferences::put(const std::string& domain, const std::string& key, const Value& value) {
  if (memory::holdsObject(value)) throw CallError("an object can not be kept");
  Value& kept = domains_[domain][key];
  bytes_ += sizeOf(domain, key, value) - sizeOf(domain, key, kept);
  kept = value;
}

void Preferences::set(const std::string& domain, const std::string& key, const Value& value) {
  if (bytes_ + sizeOf(domain, key, value) > kMostBytes) {
    throw CallError("there is no more room for preferences");
  }
  if (file_.hasPlace() && !memory::holdsObject(value)) {
    KeptLines::check(lineOf(domain, key, value));
  }
  put(domain, key, value);
  saveSoon();
}

const Preferences::Domain* Preferences::find(const std::string& domain) const {
  const auto found = domains_.find(domain);
  return found == domains_.end() ? nullptr : &found->second;
}

void Preferences::remove(const std::string& domain, const std::string& key) {
  const auto of = domains_.find(domain);
  if (of == domains_.end() || of->second.count(key) == 0) {
    throw CallError("there is no preference " + key + " of " + domain);
  }
  bytes_ -= sizeOf(domain, key, of->second.at(key));
  of->second.erase(key);
  if (of->second.empty()) domains_.erase(of);
  saveSoon();
}

void Preferences::removeDomain(const std::string& domain) {
  const auto of = domains_.find(domain);
  if (of == domains_.end()) return;
  for (const auto& [key, value] : of->second) bytes_ -= sizeOf(domain, key, value);
  domains_.erase(of);
  saveSoon();
}

void Preferences::saveSoon() {
  if (!file_.hasPlace() || is_dirty_) return;
  is_dirty_ = true;
  context_.later(kSaveAfter, [weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->save();
  });
}

void Preferences::save() {
  if (!is_dirty_) return;
  is_dirty_ = false;
  std::vector<KeptLines::Line> lines;
  for (const auto& [domain, values] : domains_) {
    for (const auto& [key, value] : values) lines.push_back(lineOf(domain, key, value));
  }
  try {
    file_.write(lines);
  } catch (const CallError& error) {
    context_.warn(std::string("preferences are not kept: ") + error.what());
  }
}

}  // namespace nao::services
