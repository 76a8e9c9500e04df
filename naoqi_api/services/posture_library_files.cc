// The libraries of postures that clients write and load.

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/posture_library.h"

namespace nao::services {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

KeptLines PostureLibrary::fileOf(const std::string& library) const {
  if (library.empty()) throw CallError("expected the name of a library");
  return {data_dir_, "postures/" + library + ".jsonl", "postures"};
}

bool PostureLibrary::saveLibrary(const std::string& library) const {
  std::vector<KeptLines::Line> lines;
  for (const auto& [id, entry] : entries_) {
    if (!entry.saved) continue;
    Value::Map angles{"s", "m", {}};
    for (std::size_t i = 0; i < entry.angle.size(); ++i) {
      angles.entries.emplace_back(link_.model().actuators[i].name, entry.angle[i]);
    }
    lines.push_back({{"id", id}, {"name", entry.name}, {"angles", std::move(angles)}});
  }
  fileOf(library).write(lines);
  return true;
}

std::pair<int, PostureLibrary::Entry> PostureLibrary::readEntry(const KeptLines::Line& line) const {
  const int id = KeptLines::find(line, "id")->to<int>();
  const std::string name = KeptLines::find(line, "name")->to<std::string>();
  const auto angles = KeptLines::find(line, "angles")->to<std::map<std::string, double>>();
  Entry entry{name, {}, JointArray<double>(link_.model().jointCount()), true};
  for (const auto& [joint, angle] : angles) {
    const auto known = link_.model().findJoint(joint);
    if (!known) throw CallError("this robot has no joint " + joint);
    entry.angle[*known] = finite(angle);
  }
  const auto own = entries_.find(id);
  if (id < 0 || (own != entries_.end() && !own->second.saved)) {
    throw CallError("no posture of a client can have the number " + std::to_string(id));
  }
  return {id, std::move(entry)};
}

// All of it is sound before the first posture changes.
bool PostureLibrary::loadLibrary(const std::string& library) {
  const auto lines = fileOf(library).read({"id", "name", "angles"});
  if (!lines) return false;
  if (lines->size() > kMostPostures) throw CallError("the library has too many postures");
  std::map<int, Entry> loaded;
  for (const KeptLines::Line& line : *lines) loaded.insert(readEntry(line));
  eraseSaved();
  entries_.insert(loaded.begin(), loaded.end());
  return true;
}

void PostureLibrary::declareFiles(rpc::Service& service) {
  const Argument library{"P0", "Its name; a file below --data-dir."};
  addFunction(
      service, "_savePostureLibrary", [this](const std::string& name) { return saveLibrary(name); },
      "Writes the saved postures to a library of that name; true.", library)
      .at(145);
  addFunction(
      service, "_loadPostureLibraryFromName",
      [this](const std::string& name) { return loadLibrary(name); },
      "Takes the postures of a library in place of those saved; false if there is none of that "
      "name.",
      library)
      .at(142);
  addFunction(
      service, "_getCurrentPath", [this] { return currentPath(); },
      "The numbers of the postures that the robot is on its way to, the next one first; empty if "
      "it goes to none.")
      .at(143);
}

}  // namespace nao::services
