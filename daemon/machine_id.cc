#include "daemon/machine_id.h"

#include <boost/uuid/name_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>

namespace nao::daemon {

std::string machineId() {
  std::string system;
  std::ifstream("/etc/machine-id") >> system;
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::dns());
  return boost::uuids::to_string(generator("usarnaoqi." + system));
}

}  // namespace nao::daemon
