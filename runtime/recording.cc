#include "runtime/recording.h"

#include <cstring>
#include <fstream>

#include "runtime/recording_format.h"

namespace nao::runtime {
namespace {

constexpr char kSqlite[] = "SQLite format 3";  // how its files begin, with the closing 0

void checkKind(Database& database) {
  const auto pragma = [&database](const char* name) {
    auto query = database.prepare(std::string("PRAGMA ") + name);
    return query.next() ? query.integer(0) : 0;
  };
  if (pragma("application_id") != kRecordingId) database.fail("is no recording of a run");
  if (const auto version = pragma("user_version"); version != kRecordingVersion) {
    database.fail("is a recording of version " + std::to_string(version) + ", expected " +
                  std::to_string(kRecordingVersion));
  }
}

// Calls `use` on the value of this name, if there is one.
template <class Use>
bool findValue(Database& database, const char* name, Use use) {
  auto query = database.prepare("SELECT value FROM run WHERE name = ?");
  if (!query.bind(1, std::string(name)).next()) return false;
  use(query);
  return true;
}

std::int64_t integerOf(Database& database, const char* name) {
  std::int64_t value = 0;
  if (!findValue(database, name, [&value](auto& row) { value = row.integer(0); })) {
    database.fail(std::string("does not say its ") + name);
  }
  return value;
}

RunStart readStart(Database& database) {
  RunStart start;
  start.step = Duration(integerOf(database, "step_ns"));
  start.mode = static_cast<sim::Mode>(integerOf(database, "mode"));
  start.seed = static_cast<std::uint64_t>(integerOf(database, "seed"));
  start.any_step = integerOf(database, "any_step") != 0;
  findValue(database, "world_model", [&start](auto& row) {
    start.world = std::make_shared<const WorldModel>(fromBytes<WorldModel>(row.bytes(0)));
  });
  if (!start.world) database.fail("has no world");
  auto robots = database.prepare("SELECT setup FROM robot ORDER BY number");
  while (robots.next()) start.robots.push_back(fromBytes<sim::RobotSetup>(robots.bytes(0)));
  return start;
}

void readInputs(Database& database, Recording& recording) {
  InputCodec codec;
  auto rows = database.prepare(
      "SELECT elapsed_ns, time_ns, place, robot, content FROM input ORDER BY number");
  while (rows.next()) {
    Recording::TimedInput one;
    one.elapsed = Duration(rows.integer(0));
    one.input.time = SimTime(Duration(rows.integer(1)));
    one.input.place = static_cast<Input::Place>(rows.integer(2));
    one.input.robot = static_cast<std::size_t>(rows.integer(3));
    if (one.input.robot >= recording.start.robots.size()) {
      throw InputError("an input is for a robot that there is not");
    }
    for (Input::Content& content : codec.decode(rows.bytes(4), one.input.robot)) {
      one.input.content = std::move(content);
      recording.inputs.push_back(one);
    }
  }
}

void readStates(Database& database, Recording& recording) {
  auto rows =
      database.prepare("SELECT elapsed_ns, time_ns, inputs, hash FROM state ORDER BY number");
  while (rows.next()) {
    recording.states.push_back({Duration(rows.integer(0)), SimTime(Duration(rows.integer(1))),
                                static_cast<std::size_t>(rows.integer(2)),
                                static_cast<std::uint64_t>(rows.integer(3))});
  }
}

}  // namespace

Simulation RunStart::makeSimulation() const {
  sim::WorldOptions options(step);
  options.mode = mode;
  options.seed = seed;
  options.any_step = any_step;
  return {world, robots, options};
}

Recording readRecording(const std::string& file) {
  Database database(file, Database::Access::Read);
  checkKind(database);
  Recording recording;
  recording.file = file;
  try {
    recording.start = readStart(database);
    readInputs(database, recording);
    readStates(database, recording);
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.rfind(file, 0) == 0) throw;
    database.fail(what);
  }
  recording.ended = findValue(database, "ended", [](auto&) {});
  return recording;
}

bool looksRecorded(const std::string& file) {
  char begin[sizeof kSqlite] = {};
  std::ifstream(file, std::ios::binary).read(begin, sizeof begin);
  return std::memcmp(begin, kSqlite, sizeof begin) == 0;
}

}  // namespace nao::runtime
