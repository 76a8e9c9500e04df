#pragma once

#include <map>
#include <string>

#include "naoqi_api/services/kept_lines.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// Values by domain and key that outlive the daemon if there is a data directory: in a file, a
/// little after each change and at the end. Without one they are kept until the daemon ends. Lives
/// in a shared_ptr. I/O thread.
class Preferences : public std::enable_shared_from_this<Preferences> {
 public:
  using Domain = std::map<std::string, rpc::Value>;

  /// Reads `file` below the data directory. One that is broken is put aside and warned of.
  Preferences(const ServiceContext& context, const std::string& file);
  ~Preferences();
  Preferences(const Preferences&) = delete;
  Preferences& operator=(const Preferences&) = delete;

  /// @throws CallError if the value can not be kept, or there is no more room.
  void set(const std::string& domain, const std::string& key, const rpc::Value& value);
  /// @throws CallError if there is no such value.
  void remove(const std::string& domain, const std::string& key);
  void removeDomain(const std::string& domain);

  const Domain* find(const std::string& domain) const;
  const std::map<std::string, Domain>& domains() const { return domains_; }

  /// Writes what is not written yet.
  void save();

 private:
  void load();
  void put(const std::string& domain, const std::string& key, const rpc::Value& value);
  void saveSoon();

  ServiceContext context_;
  KeptLines file_;
  std::map<std::string, Domain> domains_;
  std::size_t bytes_ = 0;  // of all values and their names
  bool is_dirty_ = false;
};

}  // namespace nao::services
