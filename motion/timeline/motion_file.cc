#include "motion/timeline/motion_file.h"

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
  if (std::filesystem::is_directory(file)) return loadMotion(file / "behavior.xar", model);
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError(file.string() + ": this motion file can not be read");
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (file.extension() == ".pml") {
    return loadMotion(file.parent_path() / behaviorOfPackage(text, file.string()), model);
  }
  return readMotion(text, file.string(), model);
}

}  // namespace nao::motion
