#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace nao {
namespace {

namespace fs = std::filesystem;

// Which folder may include which. Read it downwards: a folder only names folders above it.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"core", {}},
    {"sim", {"core"}},
    {"motion", {"core"}},
    {"camera", {"core"}},
    {"walk_engine", {"core", "motion"}},
    {"runtime", {"core", "sim", "motion", "walk_engine", "camera"}},
    {"naoqi_api", {"core", "motion", "camera"}},
    {"clock", {}},
    {"daemon", {"clock", "core", "motion", "camera", "runtime", "naoqi_api"}},
    {"validation", {"core", "sim", "motion", "camera", "runtime"}},
    {"recorder", {"core", "naoqi_api", "daemon", "validation"}},
    {"ci",
     {"clock", "core", "sim", "motion", "camera", "runtime", "naoqi_api", "daemon", "validation"}},
    {"app",
     {"clock", "core", "motion", "camera", "runtime", "naoqi_api", "daemon", "validation",
      "recorder", "ci"}},
};

// Which folders may know a library: the others must not see its types.
const std::map<std::string, std::set<std::string>> kOnlyHere = {
    {"Simbody", {"sim"}},
    {"SimTK", {"sim"}},
    {"msgpack", {"naoqi_api"}},
    {"boost/asio", {"daemon"}},
    {"boost/beast", {"daemon"}},
    {"boost/mpi", {}},
    {"mpi.h", {}},
    {"openssl", {"daemon", "validation"}},
    {"yaml-cpp", {"core"}},
    {"urdf_", {"core"}},
    {"tinyxml.h", {"core"}},
    {"tinyxml2", {"motion"}},
    {"zlib.h", {"motion", "validation"}},
    {"sqlite3.h", {"runtime"}},
    {"nlohmann", {"validation", "naoqi_api", "ci"}},
    {"espeak-ng/", {"naoqi_api"}},
    {"ceres/", {"validation"}},
    {"spdlog", {"daemon", "app"}},
    {"opencv2", {}},
    {"CLI/", {"app"}}};

struct Include {
  std::string folder;
  fs::path file;
  std::string included;
};

std::vector<fs::path> allSources() {
  std::vector<fs::path> found;
  for (const auto& [folder, unused] : kMayInclude) {
    const fs::path root = fs::path(NAO_SOURCE_DIR) / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const fs::path& file = entry.path();
      if (file.extension() == ".h" || file.extension() == ".cc") found.push_back(file);
    }
  }
  return found;
}

std::vector<Include> allIncludes() {
  const std::regex include_line(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  for (const fs::path& file : allSources()) {
    const std::string folder = file.lexically_relative(NAO_SOURCE_DIR).begin()->string();
    std::ifstream in(file);
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
      if (std::regex_search(line, match, include_line)) {
        found.push_back({folder, file, match.str(1)});
      }
    }
  }
  return found;
}

TEST(Architecture, SeesTheSources) { EXPECT_GT(allIncludes().size(), 50u); }

TEST(Architecture, FoldersIncludeOnlyFoldersBelowThem) {
  for (const auto& [folder, file, included] : allIncludes()) {
    const std::string other = included.substr(0, included.find('/'));
    if (other == folder || kMayInclude.count(other) == 0) continue;
    EXPECT_TRUE(kMayInclude.at(folder).count(other)) << file << " includes " << included;
  }
}

// The rooms of validation/diagnosis. Read them downwards: a room only names rooms above it.
const std::vector<std::string> kDiagnosisRooms = {
    "maths",     // numbers alone
    "jobs",      // work that is shared by threads and processes, and kept if it is cut off
    "ensemble",  // measured and simulated repeats, and their noise
    "rig",       // one joint, or a limb, simulated
    "causes",    // what can be named, and what is said of it
    "replay",    // the whole robot, simulated along a recording
    "joint",     // the search at the joint level
    "folds",     // the same without repeats
    "report",    // what a person reads
    "whole",     // the search at the limb and robot levels
    "extend",    // what a report is good for: extension, gain, next experiment
};

std::size_t placeOfRoom(const std::string& room) {
  const auto found = std::find(kDiagnosisRooms.begin(), kDiagnosisRooms.end(), room);
  return static_cast<std::size_t>(found - kDiagnosisRooms.begin());
}

TEST(Architecture, RoomsOfTheDiagnosisIncludeOnlyRoomsAboveThem) {
  const std::regex in_room("validation/diagnosis/(\\w+)/.*");
  std::set<std::string> seen;
  for (const auto& [folder, file, included] : allIncludes()) {
    const std::string name = file.lexically_relative(NAO_SOURCE_DIR).generic_string();
    std::smatch of_file, of_included;
    if (!std::regex_match(name, of_file, in_room)) continue;
    const std::size_t own = placeOfRoom(of_file.str(1));
    EXPECT_LT(own, kDiagnosisRooms.size()) << name << " is in a room that is not listed";
    seen.insert(of_file.str(1));
    if (included.rfind("validation/diagnosis/", 0) != 0) continue;
    ASSERT_TRUE(std::regex_match(included, of_included, in_room)) << name << ", " << included;
    EXPECT_LE(placeOfRoom(of_included.str(1)), own) << name << " includes " << included;
  }
  EXPECT_EQ(seen.size(), kDiagnosisRooms.size());
}

TEST(Architecture, LibrariesStayInTheirFolders) {
  for (const auto& [folder, file, included] : allIncludes()) {
    for (const auto& [library, homes] : kOnlyHere) {
      if (included.rfind(library, 0) != 0) continue;
      EXPECT_TRUE(homes.count(folder)) << file << " includes " << included;
    }
  }
}

TEST(Architecture, NaoQiServicesNeverSeeTheTruth) {
  for (const auto& [folder, file, included] : allIncludes()) {
    if (folder != "naoqi_api" && folder != "motion" && folder != "walk_engine") continue;
    EXPECT_NE(included, "core/scene_frame.h") << file;
  }
}

// Elsewhere time is simulated, or runs would differ. Folders and files.
const std::set<std::string> kMayReadTheWall = {
    "app",
    "ci",
    "clock",
    "daemon",
    "naoqi_api/sdk/cpp",
    "naoqi_api/wire/dispatcher.cc",                    // what a call costs
    "validation/process.cc",                           // what a process takes
    "validation/diagnosis/joint_level.cc",             // what a run costs, for a budget
    "validation/diagnosis/whole/whole_diagnosis.cc"};  // the same

bool mayReadTheWall(const fs::path& file) {
  return std::any_of(kMayReadTheWall.begin(), kMayReadTheWall.end(), [&](const std::string& place) {
    return file.generic_string().rfind(place, 0) == 0;
  });
}

TEST(Architecture, WallClocksAreReadInFewPlaces) {
  const std::regex reads(R"(_clock::now|clock_gettime|gettimeofday|std::time\()");
  std::set<std::string> places;
  for (const fs::path& file : allSources()) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!std::regex_search(text, reads)) continue;
    const fs::path name = file.lexically_relative(NAO_SOURCE_DIR);
    EXPECT_TRUE(mayReadTheWall(name)) << name << " reads a wall clock";
    places.insert(name.generic_string());
  }
  EXPECT_GT(places.size(), 5U);
}

// What is only for tests, benchmarks and tools does not get into the program.
TEST(Architecture, SourcesIncludeNoTests) {
  for (const auto& [folder, file, included] : allIncludes()) {
    const std::string other = included.substr(0, included.find('/'));
    EXPECT_TRUE(other != "tests" && other != "bench" && other != "tools")
        << file << " includes " << included;
  }
}

// Tests run side by side: a file of one name for all would be another test's.
TEST(Architecture, TestsWriteIntoTheirOwnFolders) {
  const fs::path root = fs::path(NAO_SOURCE_DIR) / "tests";
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path file = entry.path();
    if (file.extension() != ".cc" || file.parent_path().filename() == "architecture") continue;
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const char* shared : {"TempDir()", "temp_directory_path()"}) {
      EXPECT_EQ(text.find(shared), std::string::npos)
          << file << ": use tests/core/temporary_folder.h";
    }
  }
}

}  // namespace
}  // namespace nao
