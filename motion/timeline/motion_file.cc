#include "motion/timeline/motion_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "motion/timeline/crg.h"
#include "motion/timeline/hulks.h"
#include "motion/timeline/kfm.h"
#include "motion/timeline/kme.h"
#include "motion/timeline/mof.h"
#include "motion/timeline/pml.h"
#include "motion/timeline/pos.h"
#include "motion/timeline/qianim.h"
#include "motion/timeline/route.h"
#include "motion/timeline/webots_motion.h"
#include "motion/timeline/xar.h"

namespace nao::motion {
namespace {

constexpr std::size_t kBeginning = 4096;  // bytes that tell the kind; free choice

struct Format {
  const char* extension;
  const char* mark;  // in the beginning of such a file; empty: only the extension tells
  Timeline (*read)(const std::string& text, const std::string& source, const RobotModel& model);
};

constexpr Format kFormats[] = {
    {".xar", "<ChoregrapheProject", readXar},
    {".crg", "!<arch>", readCrg},
    {".qianim", "<Animation", readQianim},
    {".motion", "#WEBOTS_MOTION", readWebotsMotion},
    {".kme", "play%", readKme},
    {".pos", "", readPos},
    {".mof", "motion_id", readMof},
    {".kfm", "keyFrameID", readKfm},
    {".json", "initial_positions", readHulks},
    {".route", "", readRoute},
};

// Motions without joint angles.
struct Refused {
  const char* extension;
  const char* reason;
};
constexpr Refused kRefused[] = {
    {".kmc", "paths of feet and hands in space, not joint angles"},
    {".pmt", "a path over the floor, not joint angles"},
};

// A motion's text and the file it stands in, which a folder or a package only names.
struct MotionSource {
  std::filesystem::path file;
  std::string text;
};

MotionSource openMotion(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) return openMotion(file / "behavior.xar");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": this motion file can not be read");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (file.extension() != ".pml") return {file, std::move(text)};
  return openMotion(file.parent_path() / behaviorOfPackage(text, file.string()));
}

}  // namespace

Timeline readMotion(const std::string& text, const std::string& source, const RobotModel& model) {
  const std::string extension = std::filesystem::path(source).extension().string();
  for (const Refused& refused : kRefused) {
    if (extension == refused.extension) throw InputError(source + ":1: " + refused.reason);
  }
  for (const Format& format : kFormats) {
    if (extension == format.extension) return format.read(text, source, model);
  }
  const std::string beginning = text.substr(0, kBeginning);
  for (const Format& format : kFormats) {
    const std::string mark = format.mark;
    if (!mark.empty() && beginning.find(mark) != std::string::npos) {
      return format.read(text, source, model);
    }
  }
  std::string known;
  for (const Format& format : kFormats) known += std::string(" ") + format.extension;
  throw InputError(source + ":1: no motion file of a known kind; expected one of" + known);
}

Timeline loadMotion(const std::filesystem::path& file, const RobotModel& model) {
  const MotionSource source = openMotion(file);
  return readMotion(source.text, source.file.string(), model);
}

bool isMotionFile(const std::filesystem::path& file) {
  const auto has_ending = [&](const Format& format) {
    return file.extension() == format.extension;
  };
  return std::any_of(std::begin(kFormats), std::end(kFormats), has_ending);
}

std::optional<std::filesystem::path> findCode(const std::filesystem::path& file) {
  const MotionSource source = openMotion(file);
  if (source.file.extension() != ".xar" || !hasCode(source.text, source.file.string())) return {};
  return source.file;
}

Timeline loadBox(const std::filesystem::path& file, const std::string& box,
                 const RobotModel& model) {
  MotionSource source = openMotion(file);
  if (source.file.extension() == ".crg") source.text = unpackCrg(source.text, file.string());
  std::string known;
  for (BoxTimeline& found : readXarBoxes(source.text, source.file.string(), model)) {
    if (found.box == box) return std::move(found.timeline);
    known += " \"" + found.box + "\"";
  }
  throw InputError(source.file.string() + ": no box \"" + box +
                   "\" with a timeline, expected one of" + known);
}

}  // namespace nao::motion
