#include "app/program_file.h"

#include <elf.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace nao::app {
namespace {

namespace fs = std::filesystem;

bool isProgram(const fs::path& file) {
  return !fs::is_directory(file) && ::access(file.c_str(), X_OK) == 0;
}

// What a script names in its first line; empty: it is no script.
std::string interpreterOf(std::ifstream& file) {
  std::string line;
  std::getline(file, line);
  if (line.rfind("#!", 0) != 0) return {};
  std::istringstream words(line.substr(2));
  std::string program;
  words >> program;
  if (fs::path(program).filename() == "env") words >> program;
  return findProgram(program);
}

bool isGo(std::ifstream& file, const Elf64_Phdr& note) {
  std::vector<char> bytes(note.p_filesz);
  file.seekg(static_cast<std::streamoff>(note.p_offset));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  constexpr std::size_t kName = sizeof(Elf64_Nhdr);
  return bytes.size() >= kName + 4 && std::memcmp(bytes.data() + kName, "Go\0", 4) == 0;
}

}  // namespace

std::string findProgram(const std::string& word) {
  if (word.find('/') != std::string::npos) return isProgram(word) ? word : "";
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / word;
    if (isProgram(file)) return file.string();
  }
  return {};
}

std::string whyNoClock(const std::string& program) {
  std::ifstream file(program, std::ios::binary);
  Elf64_Ehdr header{};
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  if (!file || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) {
    file.clear();
    file.seekg(0);
    const std::string interpreter = interpreterOf(file);
    return interpreter.empty() ? "" : whyNoClock(interpreter);
  }
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return "is a 32-bit program";
  bool dynamic = false;
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr part{};
    file.seekg(static_cast<std::streamoff>(header.e_phoff + i * sizeof part));
    file.read(reinterpret_cast<char*>(&part), sizeof part);
    if (!file) break;
    dynamic |= part.p_type == PT_INTERP;
    if (part.p_type == PT_NOTE && isGo(file, part)) return "is a Go program";
  }
  return dynamic ? "" : "is linked statically";
}

}  // namespace nao::app
