#include "naoqi_api/services/service_directory.h"

#include "core/check.h"
#include "naoqi_api/service_hub.h"

namespace nao::services {
namespace {

/// A ServiceInfo with as many fields as this endpoint's clients expect.
template <ServiceInfoFields kFields>
struct WireInfo {
  ServiceInfo info;
};

}  // namespace
}  // namespace nao::services

namespace nao::rpc {

template <services::ServiceInfoFields kFields>
struct ValueType<services::WireInfo<kFields>> {
  static std::string signature() { return services::serviceInfoSignature(kFields); }
  static Value make(const services::WireInfo<kFields>& info) {
    return services::toValue(info.info, kFields);
  }
  static services::WireInfo<kFields> read(const Value& value) {
    return {services::serviceInfoOf(value)};
  }
};

}  // namespace nao::rpc

namespace nao::services {
namespace {

template <ServiceInfoFields kFields>
class ServiceDirectory {
 public:
  using Info = WireInfo<kFields>;

  explicit ServiceDirectory(rpc::ServiceHub& hub) : hub_(hub) {}

  rpc::Service describe() {
    using rpc::Argument;
    return rpc::Service("ServiceDirectory", "Which services there are, and where.")
        .method("service", this, &ServiceDirectory::service, "Where a service is.",
                Argument{"name", "Its name."})
        .method("services", this, &ServiceDirectory::services, "Where every service is.")
        .method("registerService", this, &ServiceDirectory::registerService,
                "Enters a service of the caller; returns its number.",
                Argument{"info", "Where it is; its serviceId is ignored."})
        .method("unregisterService", this, &ServiceDirectory::unregisterService,
                "Removes a service of the caller.", Argument{"serviceId", "Its number."})
        .method("serviceReady", this, &ServiceDirectory::serviceReady,
                "Makes an entered service visible.", Argument{"serviceId", "Its number."})
        .method("updateServiceInfo", this, &ServiceDirectory::updateServiceInfo,
                "Changes where a service of the caller is.", Argument{"info", "Where it is now."})
        .signal("serviceAdded", hub_.serviceAdded())
        .signal("serviceRemoved", hub_.serviceRemoved())
        .method("machineId", this, &ServiceDirectory::machineId, "The machine this runs on.")
        .method("_socketOfService", this, &ServiceDirectory::socketOfService,
                "Refused: it means something only inside a NAOqi process.",
                Argument{"serviceId", "The number of a service."});
  }

 private:
  Info service(const rpc::Caller& caller, const std::string& name) {
    const auto* entry = hub_.find(name);
    if (!entry) throw rpc::CallError("Cannot find service '" + name + "' in index");
    NAO_CHECK(caller.session != nullptr);
    return {hub_.infoFor(*entry, *caller.session)};
  }

  std::vector<Info> services(const rpc::Caller& caller) {
    NAO_CHECK(caller.session != nullptr);
    std::vector<Info> infos;
    for (const auto& [id, entry] : hub_.entries()) {
      if (entry.ready) infos.push_back({hub_.infoFor(entry, *caller.session)});
    }
    return infos;
  }

  std::uint32_t registerService(const rpc::Caller& caller, const Info& info) {
    checkSize(info.info);
    return hub_.enter(info.info, caller.session);
  }

  void unregisterService(const rpc::Caller& caller, std::uint32_t id) {
    checkOwner(caller, id, "Unregister Service: ");
    hub_.remove(id);
  }

  void serviceReady(const rpc::Caller& caller, std::uint32_t id) {
    checkOwner(caller, id, "Service Ready: ");
    hub_.setReady(id);
  }

  void updateServiceInfo(const rpc::Caller& caller, const Info& info) {
    checkOwner(caller, info.info.service_id, "Update Service Info: ");
    checkSize(info.info);
    hub_.update(info.info);
  }

  std::string machineId() { return hub_.options().machine_id; }

  rpc::ObjectRef socketOfService(std::uint32_t /*id*/) {
    throw rpc::CallError("a socket can not be handed out");
  }

  static void checkSize(const ServiceInfo& info) {
    std::size_t letters =
        info.name.size() + info.machine_id.size() + info.session_id.size() + info.object_uid.size();
    for (const std::string& endpoint : info.endpoints) letters += endpoint.size() + 1;
    constexpr std::size_t kMost = 64U << 10U;
    if (letters > kMost) throw rpc::CallError("the ServiceInfo is too large");
  }

  // Clients manage their own services, not each other's, and never the robot's.
  void checkOwner(const rpc::Caller& caller, std::uint32_t id, const std::string& what) {
    const auto* entry = hub_.find(id);
    if (!entry) throw rpc::CallError(what + "Can't find service #" + std::to_string(id));
    if (entry->owner != caller.session) {
      throw rpc::CallError(what + "service #" + std::to_string(id) + " is not the caller's");
    }
  }

  rpc::ServiceHub& hub_;
};

template <ServiceInfoFields kFields>
std::shared_ptr<rpc::Service> make(rpc::ServiceHub& hub) {
  const auto directory = std::make_shared<ServiceDirectory<kFields>>(hub);
  return std::make_shared<rpc::Service>(directory->describe().owning(directory));
}

}  // namespace

std::shared_ptr<rpc::Service> makeServiceDirectory(rpc::ServiceHub& hub) {
  return hub.options().personality.service_info == ServiceInfoFields::Six
             ? make<ServiceInfoFields::Six>(hub)
             : make<ServiceInfoFields::Seven>(hub);
}

}  // namespace nao::services
