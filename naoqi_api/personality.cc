#include "naoqi_api/personality.h"

#include "core/check.h"

namespace nao::rpc {

Personality Personality::naoqi() {
  Personality personality;
  personality.capabilities = {{"ClientServerSocket", true},  {"MessageFlags", true},
                              {"MetaObjectCache", false},    {"ObjectPtrUID", true},
                              {"RelativeEndpointURI", true}, {"RemoteCancelableCalls", true}};
  return personality;
}

namespace {

struct Release {
  const char* name;  // what a user says
  int number;
  const char* version;  // one that was published
  bool object_ids;      // ObjectPtrUID
  bool relative;        // RelativeEndpointURI: services at qi:<name>
  bool cancels;         // RemoteCancelableCalls
  bool strict;          // the first message must authenticate
  bool reflex;          // a walk stops before obstacles
  bool numbers;         // the first window of a name is name_0
  services::ServiceInfoFields service_info;
};

using Fields = services::ServiceInfoFields;

// What differs on the wire: reference table of captures and of libqi's published sources. 1.x spoke
// SOAP, which is not simulated: its wire is that of 2.1.
constexpr Release kReleases[] = {
    {"1.12", 112, "1.12.5", false, false, false, false, false, false, Fields::Six},
    {"1.14", 114, "1.14.5", false, false, false, false, false, false, Fields::Six},
    {"2.1", 201, "2.1.4.13", false, false, false, false, true, true, Fields::Six},
    {"2.5", 205, "2.5.5.5", false, false, true, false, true, true, Fields::Six},
    {"2.8", 208, "2.8.7.4", true, false, true, false, true, true, Fields::Six},
    {"2.9", 209, "2.9.5.172", true, true, true, true, true, true, Fields::Seven},
};

// Which NAOqi a robot's hardware had last, or for longest.
struct Hardware {
  const char* version;
  const char* naoqi;
};
constexpr Hardware kHardware[] = {{"V3", "1.14"}, {"V4", "2.1"}, {"V5", "2.1"}, {"V6", "2.8"}};

}  // namespace

Personality Personality::naoqi(const std::string& version) {
  std::string known;
  for (const Release& release : kReleases) {
    const std::string name = release.name;
    known += (known.empty() ? "" : ", ") + name;
    if (version != name && version.rfind(name + ".", 0) != 0) continue;
    Personality personality = naoqi();
    personality.version = version == name ? release.version : version;
    personality.release = release.number;
    personality.capabilities["ObjectPtrUID"] = release.object_ids;
    personality.capabilities["RelativeEndpointURI"] = release.relative;
    personality.capabilities["RemoteCancelableCalls"] = release.cancels;
    personality.needs_authentication = release.strict;
    personality.hides_newer = true;
    personality.has_obstacle_reflex = release.reflex;
    personality.numbers_first_window = release.numbers;
    personality.service_info = release.service_info;
    return personality;
  }
  throw InputError("--naoqi: '" + version + "' is not simulated, expected one of " + known);
}

Personality Personality::naoqiOf(const std::string& robot_version) {
  for (const Hardware& hardware : kHardware) {
    if (robot_version.rfind(hardware.version, 0) != 0) continue;
    Personality personality = naoqi(hardware.naoqi);
    personality.capabilities = naoqi().capabilities;
    personality.hides_newer = false;
    return personality;
  }
  return naoqi();
}

Personality Personality::libqi4() {
  Personality personality = naoqi();
  personality.needs_authentication = true;
  personality.service_info = services::ServiceInfoFields::Seven;
  personality.documents_members = false;
  return personality;
}

}  // namespace nao::rpc
