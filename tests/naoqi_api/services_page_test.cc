#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "naoqi_api/documented/documented_services.h"
#include "naoqi_api/reference.h"
#include "naoqi_api/services/robot_services.h"
#include "naoqi_api/signature.h"

namespace nao::services {
namespace {

using rpc::Answer;

/// All services of a robot that stands still.
class ServicesPage : public testing::Test {
 protected:
  ServicesPage() : link_(model(), setup_.ports), services_(link_, setup_), hub_({}) {
    services_.addTo(hub_);
  }

  static std::shared_ptr<const RobotModel> model() {
    return loadRobotModel(std::string(NAO_SOURCE_DIR) + "/robots", "nao_h25_v50");
  }
  static RobotServicesSetup makeSetup() {
    RobotServicesSetup setup;
    setup.ports = std::make_shared<motion::RobotPorts>();
    setup.images = std::make_shared<camera::ImageFeed>();
    setup.robot_name = "nao";
    return setup;
  }
  static std::string page() {
    std::ifstream file(std::string(NAO_SOURCE_DIR) + "/docs/services.md");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  RobotServicesSetup setup_ = makeSetup();
  RobotLink link_;
  RobotServices services_;
  rpc::ServiceHub hub_;
};

TEST_F(ServicesPage, IsWhatTheDeclarationsSay) {
  EXPECT_EQ(page(), rpc::coveragePage(hub_))
      << "build/usarnaoqi describe --services --markdown > docs/services.md";
}

bool declares(const rpc::Service& service, const std::string& name) {
  const auto& methods = service.methods();
  return std::any_of(methods.begin(), methods.end(),
                     [&](const auto& entry) { return entry.second.name == name; });
}

TEST_F(ServicesPage, HasEveryDocumentedMethod) {
  for (const DocumentedService& documented : documentedServices()) {
    const auto service = hub_.findService(documented.name);
    ASSERT_TRUE(service) << documented.name;
    for (const DocumentedMethod& method : documented.methods) {
      const bool is_known = method.parameters != "(?)";
      const auto count = is_known ? rpc::Signature::of(method.parameters).children().size() : 0;
      if (!is_known && declares(*service, method.name)) continue;
      EXPECT_TRUE(service->findMethod(method.name, std::vector<rpc::Value>(count, 0)))
          << documented.name << "." << method.name << method.parameters;
    }
  }
}

TEST_F(ServicesPage, MethodsThatAreNotSimulatedSaySo) {
  int refused = 0;
  for (const auto& [id, entry] : hub_.entries()) {
    if (!entry.service) continue;
    for (const auto& [uid, method] : entry.service->methods()) {
      if (method.answer != Answer::NotSimulated) {
        EXPECT_NE(method.meaning, "Not simulated.") << entry.name << "." << method.name;
        continue;
      }
      const auto outcome = method.call({}, {}).outcome();
      ASSERT_TRUE(outcome && outcome->error) << entry.name << "." << method.name;
      EXPECT_NE(outcome->error->find("not simulated"), std::string::npos) << *outcome->error;
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_F(ServicesPage, NoClientCanStopTheHostOrRunCodeOnIt) {
  const std::vector<std::pair<std::string, std::string>> methods = {
      {"ALSystem", "shutdown"},
      {"ALSystem", "reboot"},
      {"ALSystem", "upgrade"},
      {"ALSystem", "changePassword"},
      {"ALLauncher", "launchExecutable"},
      {"ALLauncher", "launchLocal"},
      {"ALLauncher", "launchScript"},
      {"ALLauncher", "launchPythonModule"},
      {"ALPythonBridge", "eval"},
      {"ALPythonBridge", "evalReturn"},
      {"ALPythonBridge", "evalFull"}};
  for (const auto& [service, name] : methods) {
    for (const auto& [uid, method] : hub_.findService(service)->methods()) {
      if (method.name == name) {
        EXPECT_EQ(method.answer, Answer::NotSimulated) << service << "." << name;
      }
    }
  }
}

// One name may have several forms: the help is of the first.
TEST_F(ServicesPage, EveryMethodOfEveryServiceHasItsHelp) {
  int helped = 0;
  for (const auto& [id, entry] : hub_.entries()) {
    if (!entry.service || !declares(*entry.service, "getMethodHelp")) continue;
    const auto list = entry.service->call("getMethodList", {}).outcome();
    for (const rpc::Value& name : *list->value->findItems()) {
      const auto help = entry.service->call("getMethodHelp", {name}).outcome();
      ASSERT_TRUE(help && help->value) << entry.name << "." << name.print();
      const auto& parts = *help->value->findItems();
      ASSERT_EQ(parts.size(), 4U);
      EXPECT_EQ(parts[0], name);
      EXPECT_FALSE(parts[1].findText()->empty()) << entry.name << "." << name.print();
      for (const rpc::Value& argument : *parts[2].findItems()) {
        for (const rpc::Value& text : *argument.findItems()) {
          EXPECT_FALSE(text.findText()->empty()) << entry.name << "." << name.print();
        }
      }
      ++helped;
    }
    EXPECT_TRUE(entry.service->call("getModuleHelp", {}).outcome()->value) << entry.name;
  }
  EXPECT_GT(helped, 2000);
}

// The name of one row's method and how many arguments it takes; none if its shape is not known.
struct Row {
  std::string method;
  std::size_t arguments = 0;
};

// Fields of a line of comma-separated values.
std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') {
      quoted = !quoted;
    } else if (letter == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += letter;
    }
  }
  return fields;
}

std::vector<Row> rowsOf(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const auto head = fieldsOf(line);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
  };
  const std::size_t method = column("method");
  const std::size_t arguments = column("qi_args");
  const std::size_t of_all = column("generic_ALModule");
  while (std::getline(stream, line)) {
    const auto fields = fieldsOf(line);
    const bool none = fields.at(arguments) == "(v)";  // C's way to say so
    const auto shape = rpc::Signature::parse(none ? "()" : fields.at(arguments));
    if (shape && fields.at(of_all) != "y")
      rows.push_back({fields.at(method), shape->children().size()});
  }
  return rows;
}

// What every qi object has.
bool isOfEveryObject(const std::string& method) {
  return method == "isStatsEnabled" || method == "isTraceEnabled" || method == "clearStats";
}

TEST_F(ServicesPage, AnswersAllThatIsKnownOfNaoqi) {
  const std::filesystem::path folder =
      std::filesystem::path(NAO_SOURCE_DIR) / ".." / "shared" / "data" / "api";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no " << folder;
  int rows = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().stem();
    if (name[0] == '_' || name.find("wire_uids") == 0) continue;
    const auto service = hub_.findService(name);
    ASSERT_TRUE(service) << name;
    for (const Row& row : rowsOf(file.path())) {
      if (isOfEveryObject(row.method)) continue;
      ++rows;
      EXPECT_TRUE(service->findMethod(row.method, std::vector<rpc::Value>(row.arguments, 0)))
          << name << "." << row.method << " of " << row.arguments;
    }
  }
  EXPECT_GT(rows, 1500);
}

}  // namespace
}  // namespace nao::services
