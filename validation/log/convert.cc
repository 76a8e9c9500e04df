#include "validation/log/convert.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>

#include "core/check.h"
#include "core/files.h"
#include "validation/log/convert_formats.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool isJson(const std::string& file) {
  return endsWith(file, ".json") || endsWith(file, ".json.gz");
}

bool isTable(const std::string& file) {
  return isJson(file) || endsWith(file, ".csv") || endsWith(file, ".csv.gz");
}

void makeRepeats(LogSet& set, const std::string& motion) {
  for (std::size_t r = 0; r < set.runs.size(); ++r) {
    set.runs[r].motion = motion;
    set.runs[r].repeat = static_cast<int>(r);
  }
}

}  // namespace

std::vector<std::string> listLogFiles(const std::string& from) {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(from)) {
    files.push_back(from);
  } else {
    for (const std::filesystem::path& entry : listFolder(from)) {
      if (std::filesystem::is_regular_file(entry)) files.push_back(entry.string());
    }
  }
  if (files.empty()) throw InputError(from + ": expected files of a recording, found none");
  if (std::any_of(files.begin(), files.end(), isTable)) {
    files.erase(std::remove_if(files.begin(), files.end(), std::not_fn(isTable)), files.end());
  }
  return files;
}

void splitByOrder(LogSet& set) {
  for (std::size_t r = 0; r < set.runs.size() && set.runs.size() > 1; ++r) {
    const std::size_t left = set.runs.size() - r;
    set.runs[r].split = left == 1 ? Split::Test : left == 2 ? Split::Select : Split::Fit;
  }
}

std::string stemOf(const std::string& file) {
  return std::filesystem::path(file).stem().stem().string();
}

void addJoints(LogSet& set) {
  for (const LogRun& run : set.runs) {
    for (const auto& [name, values] : run.columns) {
      const std::string joint = findColumnJoint(name);
      const bool known = std::any_of(set.joints.begin(), set.joints.end(),
                                     [&](const LogJoint& other) { return other.name == joint; });
      if (joint.empty() || known) continue;
      set.joints.emplace_back();
      set.joints.back().name = joint;
    }
  }
}

double calcRate(const LogSet& set) {
  double rows = 0, time = 0;
  for (const LogRun& run : set.runs) {
    rows += static_cast<double>(run.t.size()) - 1;
    time += run.t.back() - run.t.front();
  }
  return time > 0 ? rows / time : 1;
}

LogFormat guessFormat(const std::string& from) {
  const std::string file = listLogFiles(from).front();
  if (isJson(file)) return LogFormat::Bam;
  const std::string text = readPacked(file);
  const std::string header = text.substr(0, text.find('\n'));
  if (header.find("Device/SubDeviceList/") != std::string::npos) return LogFormat::Almemory;
  if (header.find("position.") != std::string::npos) return LogFormat::Poppy;
  const auto first = static_cast<unsigned char>(text.empty() ? ' ' : text[0]);
  const bool map = (first & 0xf0) == 0x80 || first == 0xde || first == 0xdf;  // of MessagePack
  if (map) return LogFormat::Lola;
  throw InputError(file +
                   ": expected JSON files of BAM, a CSV file of ALMemory keys or of Poppy, or LoLA "
                   "frames; say --format if it is one of them");
}

LogSet convertLog(const std::string& from, LogFormat format, const ConvertSettings& settings) {
  LogSet set;
  switch (format) {
    case LogFormat::Bam:
      set = convertBam(from);
      break;
    case LogFormat::Poppy:
      set = convertPoppy(from);
      break;
    case LogFormat::Almemory:
      set = convertMemory(from);
      break;
    case LogFormat::Lola:
      set = convertLola(from);
      break;
  }
  if (!settings.robot.empty()) set.robot = settings.robot;
  if (!settings.licence.empty()) set.licence = settings.licence;
  for (LogRun& run : set.runs) run.split = settings.split.value_or(run.split);
  if (!settings.motion.empty()) makeRepeats(set, settings.motion);
  set.environment.suspended = set.environment.suspended || settings.suspended;
  return set;
}

std::vector<std::string> leaveOutUnknownJoints(LogSet& set, const RobotModel& model) {
  std::vector<std::string> unknown;
  for (const LogJoint& joint : set.joints) {
    const auto ours = model.findJoint(joint.name);
    if (!ours || model.actuators[index(*ours)].name != joint.name) unknown.push_back(joint.name);
  }
  const auto isUnknown = [&](const std::string& name) {
    return std::find(unknown.begin(), unknown.end(), name) != unknown.end();
  };
  const auto goes = [&](const LogJoint& joint) { return isUnknown(joint.name); };
  set.joints.erase(std::remove_if(set.joints.begin(), set.joints.end(), goes), set.joints.end());
  for (LogRun& run : set.runs) {
    for (auto at = run.columns.begin(); at != run.columns.end();) {
      at = isUnknown(findColumnJoint(at->first)) ? run.columns.erase(at) : std::next(at);
    }
  }
  return unknown;
}

}  // namespace nao::validation
