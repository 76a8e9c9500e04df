#include "naoqi_api/service_hub.h"

#include <algorithm>
#include <chrono>

#include "core/check.h"
#include "naoqi_api/object_uid.h"
#include "naoqi_api/services/service_directory.h"
#include "naoqi_api/signal_tracer.h"

namespace nao::rpc {

using services::ServiceInfo;

ServiceHub::ServiceHub(HubOptions options)
    : options_(std::move(options)), tasks_(options_.alarm, options_.task_ids) {
  if (!options_.clock) options_.clock = [] { return Duration(0); };
  add(services::makeServiceDirectory(*this));
}

std::uint32_t ServiceHub::insert(Entry entry) {
  entry.id = next_id_++;
  const std::uint32_t id = entry.id;
  entries_.emplace(id, std::move(entry));
  return id;
}

std::uint32_t ServiceHub::add(std::shared_ptr<Service> service) {
  NAO_CHECK(find(service->name()) == nullptr);
  traceSignals(service);
  Entry entry;
  entry.name = service->name();
  entry.service = std::move(service);
  const std::uint32_t id = insert(std::move(entry));
  setReady(id);
  return id;
}

void ServiceHub::traceSignals(const std::shared_ptr<Service>& service) {
  SignalTracer::watch(service, [this, alive = std::weak_ptr<int>(alive_)](
                                   Service& traced, std::uint32_t uid, const auto& arguments) {
    if (alive.expired()) return;
    const auto now = std::chrono::duration_cast<std::chrono::microseconds>(options_.clock());
    traced.monitor().trace(takeTraceId(), Monitor::Event::Signal, uid, Value::list(arguments),
                           now.count());
  });
}

std::uint32_t ServiceHub::enter(ServiceInfo info, const std::shared_ptr<Session>& owner) {
  std::size_t owned = 0;
  for (const auto& [id, entry] : entries_) {
    if (entry.name == info.name) {
      throw CallError("Service \"" + info.name + "\" (#" + std::to_string(id) +
                      ") is already registered. Rejecting conflicting registration attempt.");
    }
    owned += entry.owner == owner ? 1 : 0;
  }
  if (owned >= kMostPerClient) throw CallError("too many services from one client");
  Entry entry;
  entry.name = info.name;
  entry.info = std::move(info);
  entry.owner = owner;
  const std::uint32_t id = insert(std::move(entry));
  if (!owner) return id;
  owner->onEnd([this, id, alive = std::weak_ptr<int>(alive_)] {
    if (!alive.expired()) remove(id);
  });
  return id;
}

void ServiceHub::setReady(std::uint32_t id) {
  const auto found = entries_.find(id);
  if (found == entries_.end() || found->second.ready) return;
  found->second.ready = true;
  added_(id, found->second.name);
}

void ServiceHub::update(const ServiceInfo& info) {
  const auto found = entries_.find(info.service_id);
  if (found == entries_.end() || found->second.service) return;
  found->second.info = info;
}

void ServiceHub::remove(std::uint32_t id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return;
  const Entry entry = std::move(found->second);
  entries_.erase(found);
  if (entry.ready) removed_(id, entry.name);
}

const ServiceHub::Entry* ServiceHub::find(std::uint32_t id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

const ServiceHub::Entry* ServiceHub::find(std::string_view name) const {
  for (const auto& [id, entry] : entries_) {
    if (entry.ready && entry.name == name) return &entry;
  }
  return nullptr;
}

std::shared_ptr<Service> ServiceHub::findService(std::string_view name) const {
  const Entry* entry = find(name);
  return entry ? entry->service : nullptr;
}

std::shared_ptr<RemoteObject> ServiceHub::findRemote(std::string_view name) const {
  const Entry* entry = find(name);
  return entry && entry->owner ? entry->owner->reach(entry->id) : nullptr;
}

Pending<std::shared_ptr<Service>> ServiceHub::reach(std::uint32_t id) {
  using Found = Pending<std::shared_ptr<Service>>;
  const Entry* entry = find(id);
  if (!entry || !entry->ready) return Found::failed("there is no service of that number");
  if (entry->service) return Found::done(entry->service);
  if (entry->offer) return Found::done(entry->offer);
  const auto remote = entry->owner ? entry->owner->reach(id) : nullptr;
  if (!remote) return Found::failed("the service can not be reached from here");
  const auto offered = remote->offer();
  offered.whenDone([this, id, alive = std::weak_ptr<int>(alive_)](const auto& outcome) {
    const auto found = alive.expired() ? entries_.end() : entries_.find(id);
    if (outcome.value && found != entries_.end()) found->second.offer = *outcome.value;
  });
  return offered;
}

namespace {

bool isWithin(const std::vector<std::string>& some, const std::vector<std::string>& all) {
  return std::all_of(some.begin(), some.end(), [&](const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  });
}

}  // namespace

// Those of all services that are reached where this one is.
std::vector<std::string> ServiceHub::relativeEndpoints(const Entry& entry) const {
  std::vector<std::string> endpoints;
  for (const auto& [id, other] : entries_) {
    const bool is_ours = entry.service && other.service;
    const bool is_beside = entry.owner && other.owner && other.ready &&
                           isWithin(other.info.endpoints, entry.info.endpoints);
    if (is_ours || is_beside) endpoints.push_back("qi:" + other.name);
  }
  return endpoints;
}

ServiceInfo ServiceHub::infoFor(const Entry& entry, const Session& session) const {
  ServiceInfo info = entry.info;
  info.name = entry.name;
  info.service_id = entry.id;
  if (session.takesRelativeEndpoints()) {
    const auto relative = relativeEndpoints(entry);
    info.endpoints.insert(info.endpoints.begin(), relative.begin(), relative.end());
  }
  if (!entry.service) {
    if (entry.info.endpoints.empty()) info.endpoints.push_back(session.endpoint());  // through us
    return info;
  }
  info.machine_id = options_.machine_id;
  info.process_id = options_.process_id;
  info.endpoints.push_back(session.endpoint());
  const bool is_directory = entry.id == 1;
  info.session_id = is_directory ? "0" : options_.machine_id;
  if (!is_directory) info.object_uid = objectUid(options_.machine_id + entry.name);
  return info;
}

}  // namespace nao::rpc
