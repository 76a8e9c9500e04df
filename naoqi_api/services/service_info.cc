#include "naoqi_api/services/service_info.h"

namespace nao::services {

using rpc::Value;

std::string serviceInfoSignature(ServiceInfoFields fields) {
  return fields == ServiceInfoFields::Six
             ? "(sIsI[s]s)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId>"
             : "(sIsI[s]ss)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId,"
               "objectUid>";
}

Value toValue(const ServiceInfo& info, ServiceInfoFields fields) {
  std::vector<Value> items = {info.name,
                              info.service_id,
                              info.machine_id,
                              info.process_id,
                              rpc::toValue(info.endpoints),
                              info.session_id};
  if (fields == ServiceInfoFields::Seven) items.emplace_back(info.object_uid);
  return Value::tuple(serviceInfoSignature(fields), std::move(items));
}

ServiceInfo serviceInfoOf(const Value& value) {
  const auto* items = value.findItems();
  if (!items || items->size() < 6) throw rpc::CallError("expected a ServiceInfo");
  ServiceInfo info;
  info.name = (*items)[0].to<std::string>();
  info.service_id = (*items)[1].to<std::uint32_t>();
  info.machine_id = (*items)[2].to<std::string>();
  info.process_id = (*items)[3].to<std::uint32_t>();
  info.endpoints = (*items)[4].to<std::vector<std::string>>();
  info.session_id = (*items)[5].to<std::string>();
  if (items->size() > 6) info.object_uid = (*items)[6].to<std::string>();
  return info;
}

}  // namespace nao::services
