#include "runtime/recorder.h"

#include <filesystem>

#include "runtime/recording_format.h"
#include "runtime/run_hash.h"

namespace nao::runtime {
namespace {

constexpr Duration kCommitEvery = std::chrono::milliseconds(800);

constexpr char kTables[] = R"(
CREATE TABLE run (name TEXT PRIMARY KEY, value);
CREATE TABLE robot (number INTEGER PRIMARY KEY, name TEXT, model TEXT, setup BLOB);
CREATE TABLE input (number INTEGER PRIMARY KEY, elapsed_ns INTEGER, time_ns INTEGER,
                    place INTEGER, robot INTEGER, kind TEXT, content BLOB);
CREATE TABLE state (number INTEGER PRIMARY KEY, elapsed_ns INTEGER, time_ns INTEGER,
                    inputs INTEGER, hash INTEGER);
)";

// What was no recording is not to be lost, nor one that somebody is writing.
void makeRoom(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file)) return;
  if (!looksRecorded(file) && !std::filesystem::is_empty(file, ignored)) {
    throw InputError(file + ": is there and is no recording, expected a new name");
  }
  if (looksRecorded(file)) Database(file, Database::Access::Read).run("BEGIN EXCLUSIVE; ROLLBACK");
  for (const char* part : {"", "-journal"}) std::filesystem::remove(file + part, ignored);
}

std::int64_t count(Duration duration) { return duration.count(); }

}  // namespace

/// What waits for the next commit, and where it goes.
struct Recorder::Pending {
  using Kind = std::pair<std::size_t, std::size_t>;  // which content, which request
  struct Row {
    Duration elapsed{};
    SimTime time{};
    Input::Place place{};
    std::size_t robot = 0;
    Kind kind;
    std::string name;
    Bytes content;
  };

  static Kind kindOf(const Input& one) {
    const auto* motion = std::get_if<motion::MotionRequest>(&one.content);
    const auto* world = std::get_if<WorldRequest>(&one.content);
    return {one.content.index(), motion ? motion->action.index() : world ? world->index() : 0};
  }

  explicit Pending(const std::string& file)
      : database((makeRoom(file), file), Database::Access::Create) {}

  void create(const RunStart& start) {
    database.run("PRAGMA locking_mode = EXCLUSIVE; PRAGMA synchronous = OFF; BEGIN");
    database.run("PRAGMA application_id = " + std::to_string(kRecordingId));
    database.run("PRAGMA user_version = " + std::to_string(kRecordingVersion));
    database.run(kTables);
    auto value = database.prepare("INSERT INTO run VALUES (?, ?)");
    const auto put = [&value](const std::string& name, const auto& what) {
      value.bind(1, name).bind(2, what).next();
    };
    put("world", start.world->name);
    put("world_model", toBytes(*start.world));
    put("step_ns", count(start.step));
    put("mode", static_cast<std::int64_t>(start.mode));
    put("seed", static_cast<std::int64_t>(start.seed));
    put("any_step", static_cast<std::int64_t>(start.any_step));
    auto robot = database.prepare("INSERT INTO robot (name, model, setup) VALUES (?, ?, ?)");
    for (const sim::RobotSetup& setup : start.robots) {
      robot.bind(1, setup.name).bind(2, setup.model->name).bind(3, toBytes(setup)).next();
    }
    database.run("COMMIT");
    input.emplace_back(
        database.prepare("INSERT INTO input (elapsed_ns, time_ns, place, robot, kind, content) "
                         "VALUES (?, ?, ?, ?, ?, ?)"));
    state.emplace_back(database.prepare(
        "INSERT INTO state (elapsed_ns, time_ns, inputs, hash) VALUES (?, ?, ?, ?)"));
  }

  // Inputs of one moment, robot and kind share a row.
  void add(Duration elapsed, const Input& one) {
    const bool is_more = !inputs.empty() && inputs.back().elapsed == elapsed &&
                         inputs.back().place == one.place && inputs.back().robot == one.robot &&
                         inputs.back().kind == kindOf(one) && inputs.back().time == one.time;
    if (!is_more) inputs.push_back({elapsed, one.time, one.place, one.robot, kindOf(one), {}, {}});
    if (!is_more) inputs.back().name = nameOf(one.content);
    codec.encode(one, inputs.back().content);
  }

  void write() {
    database.run("BEGIN");
    for (Row& row : inputs) {
      seal(row.content);
      input[0]
          .bind(1, count(row.elapsed))
          .bind(2, count(row.time.time_since_epoch()))
          .bind(3, static_cast<std::int64_t>(row.place))
          .bind(4, static_cast<std::int64_t>(row.robot))
          .bind(5, row.name)
          .bind(6, row.content)
          .next();
    }
    for (const Recording::State& row : states) {
      state[0]
          .bind(1, count(row.elapsed))
          .bind(2, count(row.time.time_since_epoch()))
          .bind(3, static_cast<std::int64_t>(row.inputs))
          .bind(4, static_cast<std::int64_t>(row.hash))
          .next();
    }
    database.run("COMMIT");
    inputs.clear();
    states.clear();
  }

  Database database;
  std::vector<Database::Statement> input, state;  // one each, once the tables are there
  InputCodec codec;
  std::vector<Row> inputs;
  std::vector<Recording::State> states;
};

Recorder::Recorder(const std::string& file, const RunStart& start)
    : pending_(std::make_unique<Pending>(file)) {
  pending_->create(start);
}

Recorder::~Recorder() { commit(); }

void Recorder::took(const Input& input) {
  if (!pending_) return;
  ++inputs_;
  pending_->add(elapsed_, input);
}

void Recorder::stepped(const Simulation& simulation) {
  if (!pending_) return;
  elapsed_ += simulation.stepSize();
  if (simulation.now().time_since_epoch() % RunHash::kEvery == Duration::zero()) {
    addState(simulation);
  }
  if (elapsed_ - committed_ >= kCommitEvery) commit();
}

void Recorder::finish(const Simulation& simulation) {
  if (!pending_) return;
  addState(simulation);
  commit();
  if (!pending_) return;
  try {
    pending_->database.run("INSERT OR REPLACE INTO run VALUES ('ended', 1)");
  } catch (const InputError& error) {
    failure_ = error.what();
  }
  pending_.reset();
}

void Recorder::addState(const Simulation& simulation) {
  pending_->states.push_back({elapsed_, simulation.now(), inputs_, simulation.hash()});
}

void Recorder::commit() {
  if (!pending_) return;
  committed_ = elapsed_;
  try {
    pending_->write();
  } catch (const InputError& error) {
    failure_ = error.what();
    pending_.reset();
  }
}

}  // namespace nao::runtime
