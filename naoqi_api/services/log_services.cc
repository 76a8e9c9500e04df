#include "naoqi_api/services/log_services.h"

#include <map>
#include <string>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::Value;

// LogManager's message, from the interface descriptions of lugu/qiloop.
constexpr char kLevel[] = "(i)<LogLevel,level>";
constexpr char kMoment[] = "(L)<TimePoint,ns>";

std::string messageSignature() {
  return std::string("(s") + kLevel + "sssI" + kMoment + kMoment +
         ")<LogMessage,source,level,category,location,message,id,date,systemDate>";
}

constexpr int kInfo = 4;  // 1 fatal, 2 error, 3 warning, 4 info, 5 verbose, 6 debug
constexpr int kMostListeners = 256;

/// Where messages come together.
class LogBook {
 public:
  explicit LogBook(ServiceContext context) : context_(std::move(context)) {}

  void write(int level, const std::string& category, const std::string& text) {
    const auto ns = static_cast<std::uint64_t>(context_.store().now().count());
    const Value moment = Value::tuple(kMoment, {ns});
    const Value message = Value::tuple(
        messageSignature(),
        {"", Value::tuple(kLevel, {level}), category, "", text, ++last_id_, moment, moment});
    context_.log(category + ": " + text);
    for (auto& [number, weak] : listeners_) {
      const auto listener = weak.lock();
      if (listener && level <= listener->level) listener->emitter.emit({message});
    }
  }

  std::shared_ptr<rpc::Service> makeListener() {
    for (auto entry = listeners_.begin(); entry != listeners_.end();) {
      entry = entry->second.expired() ? listeners_.erase(entry) : std::next(entry);
    }
    if (listeners_.size() >= kMostListeners) throw rpc::CallError("too many listeners");
    const auto listener = std::make_shared<Listener>();
    listeners_[++last_listener_] = listener;
    auto object = std::make_shared<rpc::Service>("LogListener", "Hears what is logged.");
    object->addSignal("onLogMessage", listener->emitter);
    addFunction(
        *object, "setLevel",
        [listener](const std::tuple<int>& level) { listener->level = std::get<0>(level); },
        "The least important level to hear.",
        Argument{"level", "1 fatal, 2 error, 3 warning, 4 info, 5 verbose, 6 debug."});
    addFunction(
        *object, "clearFilters", [listener] { listener->level = kInfo; }, "As at first: info.");
    object->owning(listener);
    return object;
  }

 private:
  struct Listener {
    rpc::Emitter emitter{"(" + messageSignature() + ")"};
    int level = kInfo;
  };

  ServiceContext context_;
  std::map<int, std::weak_ptr<Listener>> listeners_;
  int last_listener_ = 0;
  std::uint32_t last_id_ = 0;
};

std::shared_ptr<rpc::Service> makeManager(const std::shared_ptr<LogBook>& book) {
  auto service = std::make_shared<rpc::Service>("LogManager", "What is logged, for who listens.");
  for (const char* name : {"getListener", "createListener"}) {
    addFunction(
        *service, name, [book] { return book->makeListener(); },
        "An object whose signal onLogMessage tells what is logged.");
  }
  addFunction(
      *service, "log",
      [book](const Value& messages) {
        const auto* items = messages.findItems();
        if (!items) throw rpc::CallError("expected messages");
        for (const Value& message : *items) {
          const auto* fields = message.findItems();
          if (!fields || fields->size() < 5) throw rpc::CallError("expected LogMessages");
          const auto* level = (*fields)[1].findItems();
          book->write(level && !level->empty() ? level->front().to<int>() : kInfo,
                      (*fields)[2].to<std::string>(), (*fields)[4].to<std::string>());
        }
      },
      "Logs messages.", Argument{"messages", "[LogMessage, ...]"});
  service->owning(book);
  return service;
}

std::shared_ptr<rpc::Service> makeLogger(const std::shared_ptr<LogBook>& book) {
  auto service = std::make_shared<rpc::Service>(rpc::alModule("ALLogger", "Logs, as 1.x does."));
  const std::map<std::string, int> levels = {{"fatal", 1},   {"error", 2},   {"warn", 3},
                                             {"info", 4},    {"lowInfo", 5}, {"debug", 6},
                                             {"lowDebug", 6}};
  for (const auto& [name, level] : levels) {
    addFunction(
        *service, name,
        [book, level = level](const std::string& module, const std::string& text) {
          book->write(level, module, text);
        },
        "Logs a text.", Argument{"moduleName", "Who says so."}, Argument{"message", "The text."});
  }
  const auto verbosity = std::make_shared<int>(kInfo);
  addFunction(
      *service, "verbosity", [verbosity] { return *verbosity; }, "4: info, at first.");
  addFunction(
      *service, "setVerbosity",
      [verbosity, levels](const std::string& name) {
        const auto found = levels.find(name);
        if (found == levels.end()) throw rpc::CallError("unknown verbosity: " + name);
        *verbosity = found->second;
      },
      "Is kept.", Argument{"level", "fatal, error, warn, info, lowInfo, debug or lowDebug."})
      .answering(rpc::Answer::Simplified);
  return service;
}

}  // namespace

std::vector<std::shared_ptr<rpc::Service>> makeLogServices(const ServiceContext& context) {
  const auto book = std::make_shared<LogBook>(context);
  return {makeManager(book), makeLogger(book)};
}

}  // namespace nao::services
