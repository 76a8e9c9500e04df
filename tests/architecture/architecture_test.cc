#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>

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
    {"ci",
     {"clock", "core", "sim", "motion", "camera", "runtime", "naoqi_api", "daemon", "validation"}},
    {"app",
     {"clock", "core", "motion", "camera", "runtime", "naoqi_api", "daemon", "validation", "ci"}},
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

std::vector<Include> allIncludes() {
  const std::regex include_line(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  for (const auto& [folder, unused] : kMayInclude) {
    const fs::path root = fs::path(NAO_SOURCE_DIR) / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cc") continue;
      std::ifstream file(entry.path());
      std::smatch match;
      for (std::string line; std::getline(file, line);) {
        if (std::regex_search(line, match, include_line)) {
          found.push_back({folder, entry.path(), match.str(1)});
        }
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
