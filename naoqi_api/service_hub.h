#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "naoqi_api/credentials.h"
#include "naoqi_api/personality.h"
#include "naoqi_api/remote_object.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/service_info.h"
#include "naoqi_api/tasks.h"

namespace nao::rpc {

/// What the services of one endpoint share.
struct HubOptions {
  Personality personality = Personality::naoqi();
  std::string machine_id;  // a uuid, as text
  std::uint32_t process_id = 0;
  Alarm alarm;                      // for time-outs, in simulated time
  std::function<Duration()> clock;  // NaoQi's clock since its epoch; default: stands at 0
  std::shared_ptr<const Credentials> credentials;                   // null: every client is let in
  std::shared_ptr<TaskIds> task_ids = std::make_shared<TaskIds>();  // of the process
};

/// The services behind one listening address (one robot), by number and name, and the directory
/// of them that clients ask: number 1, made here. Connections find their targets in it; it knows
/// no wire. I/O thread only, and it outlives every connection.
class ServiceHub {
 public:
  struct Entry {
    std::uint32_t id = 0;
    std::string name;
    std::shared_ptr<Service> service;  // null if a client hosts it
    services::ServiceInfo info;        // of a client's service, as it registered it
    std::shared_ptr<Session> owner;    // the client that registered it
    bool ready = false;                // others do not see it before
    std::shared_ptr<Service> offer;    // what a client's service offers, once somebody asked
  };

  explicit ServiceHub(HubOptions options);
  ServiceHub(const ServiceHub&) = delete;
  ServiceHub& operator=(const ServiceHub&) = delete;

  /// Adds a service of the program; the name must be new. Returns its number.
  std::uint32_t add(Service service) { return add(std::make_shared<Service>(std::move(service))); }
  std::uint32_t add(std::shared_ptr<Service> service);

  /// Enters a service that the client `owner` hosts; invisible until setReady(). It goes when the
  /// client goes. @throws CallError if the name is taken or the client has too many.
  std::uint32_t enter(services::ServiceInfo info, const std::shared_ptr<Session>& owner);
  void setReady(std::uint32_t id);
  void update(const services::ServiceInfo& info);
  void remove(std::uint32_t id);

  const Entry* find(std::uint32_t id) const;
  const Entry* find(std::string_view name) const;  // ready ones only
  std::shared_ptr<Service> findService(std::string_view name) const;
  /// A service that a client registered, such as a module with callbacks; null if there is none
  /// of that name. Its calls are made on that client's connection.
  std::shared_ptr<RemoteObject> findRemote(std::string_view name) const;
  /// The service of that number, be it the program's or a client's, to be called from here. What a
  /// client's offers is asked first; the result fails if it is not there or can not be reached.
  Pending<std::shared_ptr<Service>> reach(std::uint32_t id);

  const std::map<std::uint32_t, Entry>& entries() const { return entries_; }

  /// What the directory tells `session` about an entry.
  services::ServiceInfo infoFor(const Entry& entry, const Session& session) const;

  const Signal<std::uint32_t, std::string>& serviceAdded() const { return added_; }
  const Signal<std::uint32_t, std::string>& serviceRemoved() const { return removed_; }

  const HubOptions& options() const { return options_; }
  Tasks& tasks() { return tasks_; }

  /// Puts what its signals emit into the trace of a service, or of an object that is handed out.
  void traceSignals(const std::shared_ptr<Service>& service);

  /// A number for a call that is traced, never used before; not 0.
  std::uint32_t takeTraceId() { return next_trace_id_++; }

  /// A session number that was never used before.
  std::uint64_t takeSessionId() { return next_session_id_++; }

 private:
  static constexpr std::size_t kMostPerClient = 256;

  std::uint32_t insert(Entry entry);
  std::vector<std::string> relativeEndpoints(const Entry& entry) const;

  HubOptions options_;
  Tasks tasks_;
  std::map<std::uint32_t, Entry> entries_;
  std::uint32_t next_id_ = 1;
  std::uint64_t next_session_id_ = 1;
  std::uint32_t next_trace_id_ = 1;
  Signal<std::uint32_t, std::string> added_;
  Signal<std::uint32_t, std::string> removed_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace nao::rpc
