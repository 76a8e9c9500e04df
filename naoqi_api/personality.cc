#include "naoqi_api/personality.h"

namespace nao::rpc {

Personality Personality::naoqi() {
  Personality personality;
  personality.capabilities = {{"ClientServerSocket", true},  {"MessageFlags", true},
                              {"MetaObjectCache", false},    {"ObjectPtrUID", true},
                              {"RelativeEndpointURI", true}, {"RemoteCancelableCalls", true}};
  return personality;
}

Personality Personality::libqi4() {
  Personality personality = naoqi();
  personality.needs_authentication = true;
  personality.service_info = services::ServiceInfoFields::Seven;
  personality.documents_members = false;
  return personality;
}

}  // namespace nao::rpc
