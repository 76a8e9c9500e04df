// The qi wire while one Nao is simulated at 1x, seen from a client in its own process: delays
// beside those of an echo socket on the same I/O thread with the same sizes, calls a second when
// they are pipelined, and events to many. wire_bench: one JSON object of figures.
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/wire_client.h"
#include "bench/wire_server.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/codec.h"

namespace nao::bench {
namespace {

using rpc::Value;
using Clock = std::chrono::steady_clock;

constexpr int kBatches = 10;
constexpr int kCallsPerBatch = 1000;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Medians over the batches.
struct Delays {
  double p50_us = 0;
  double p99_us = 0;
};

struct Batches {
  std::vector<double> p50;
  std::vector<double> p99;

  void add(std::vector<double> delays_us) {
    std::sort(delays_us.begin(), delays_us.end());
    p50.push_back(delays_us[delays_us.size() / 2]);
    p99.push_back(delays_us[delays_us.size() * 99 / 100]);
  }
  Delays medians() const { return {median(p50), median(p99)}; }
};

/// Asks the echo for messages of these sizes.
class EchoClient {
 public:
  EchoClient(std::uint16_t port, std::size_t asked, std::size_t answered)
      : client_(port), question_(asked, 'x'), answered_(answered) {
    wire::Bytes sizes;
    wire::appendNumber(sizes, static_cast<std::uint32_t>(asked));
    wire::appendNumber(sizes, static_cast<std::uint32_t>(answered));
    client_.send(sizes);
  }

  void ask() {
    client_.send(question_);
    std::size_t got = 0;
    char buffer[65536];
    while (got < answered_) {
      const ssize_t count = ::read(client_.descriptor(), buffer, sizeof buffer);
      if (count <= 0) std::abort();
      got += static_cast<std::size_t>(count);
    }
  }

 private:
  WireClient client_;
  wire::Bytes question_;
  std::size_t answered_;
};

template <class F>
std::vector<double> timed(const F& once) {
  std::vector<double> delays_us;
  for (int k = 0; k < kCallsPerBatch; ++k) {
    const auto start = Clock::now();
    once();
    delays_us.push_back(1e6 * secondsSince(start));
  }
  return delays_us;
}

/// One call and its echo, batch by batch in turn.
std::pair<Delays, Delays> compare(const WireServer& server, const wire::Address& address,
                                  const Value& arguments) {
  WireClient client(server.port);
  const std::size_t answered = wire::kHeaderSize + client.call(address, arguments).size();
  const wire::Bytes question = callFrame(address, arguments, 1);
  EchoClient echo(server.echo_port, question.size(), answered);
  Batches calls;
  Batches echos;
  for (int batch = 0; batch < kBatches; ++batch) {
    calls.add(timed([&] {
      client.send(question);
      client.receive();
    }));
    echos.add(timed([&] { echo.ask(); }));
  }
  return {calls.medians(), echos.medians()};
}

/// Calls a second with two windows of them on their way.
double pipelined(const WireServer& server, const wire::Address& address, const Value& arguments,
                 std::size_t calls) {
  constexpr std::size_t kWindow = 256;
  WireClient client(server.port);
  client.call(address, arguments);
  wire::Bytes window;
  for (std::uint32_t id = 1; id <= kWindow; ++id) {
    const wire::Bytes frame = callFrame(address, arguments, id);
    window.insert(window.end(), frame.begin(), frame.end());
  }
  const auto start = Clock::now();
  std::size_t sent = kWindow;
  std::size_t answered = 0;
  client.send(window);
  while (answered < calls) {
    if (sent < calls && sent - answered <= kWindow) {
      client.send(window);
      sent += kWindow;
    }
    client.receiveSome();
    answered += client.countMessages();
  }
  return static_cast<double>(answered) / secondsSince(start);
}

// Processor time that a process has used [s].
double processorTime(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  text = text.substr(text.rfind(')') + 2);
  unsigned long user = 0;
  unsigned long system = 0;
  std::sscanf(text.c_str(), "%*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &system);
  return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// 200 clients that all listen to 20 events, which one client raises 50 times a second.
class EventStorm {
 public:
  static constexpr int kListeners = 200;
  static constexpr int kEvents = 20;
  static constexpr int kCycles = 500;  // 10 s

  explicit EventStorm(const WireServer& server) : server_(server), publisher_(server.port) {
    memory_ = publisher_.service("ALMemory");
    raise_ = publisher_.method(memory_, "raiseEvent", "(sm)");
    const auto subscriber = publisher_.method(memory_, "subscriber", "(s)");
    for (int k = 0; k < kListeners; ++k) {
      listeners_.push_back(std::make_unique<WireClient>(server.port));
      for (int event = 0; event < kEvents; ++event) listen(*listeners_.back(), subscriber, event);
    }
  }

  void run(std::map<std::string, double>& figures) {
    const double before_s = processorTime(server_.process);
    const auto start = Clock::now();
    for (int cycle = 0; cycle < kCycles; ++cycle) {
      raiseAll(cycle);
      const auto next = start + std::chrono::milliseconds(20) * (cycle + 1);
      while (Clock::now() < next) collect(next);
    }
    const double busy_s = processorTime(server_.process) - before_s;
    figures["events_server_cpu_percent"] = 100 * busy_s / secondsSince(start);
    const auto end = Clock::now() + std::chrono::seconds(2);
    while (Clock::now() < end) collect(end);
    constexpr double kAll = double{kListeners} * kEvents * kCycles;
    figures["events_sent"] = kAll;
    figures["events_lost"] = kAll - static_cast<double>(got_);
    figures["events_pieces_per_cycle_and_listener"] =
        static_cast<double>(pieces_) / (double{kListeners} * kCycles);
  }

 private:
  static std::string nameOf(int event) { return "Storm/" + std::to_string(event); }

  void listen(WireClient& client, std::uint32_t subscriber, int event) const {
    const wire::Bytes object = client.call({memory_, 1, subscriber}, Value::tuple({nameOf(event)}));
    wire::Decoder decoder(object);
    const Value offer = decoder.read("({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)");
    const auto service = decoder.number<std::uint32_t>();
    const auto number = decoder.number<std::uint32_t>();
    const auto& signals = offer.findItems()->at(1).find<Value::Map>()->entries;
    const auto signal = *signals.back().first.find<std::uint32_t>();
    client.call({service, number, 0}, Value::tuple({service, signal, std::uint64_t{1}}));
  }

  void raiseAll(int cycle) {
    wire::Bytes posts;
    for (int event = 0; event < kEvents; ++event) {
      wire::Message message;
      message.id = 1;
      message.type = wire::MessageType::Post;
      message.address = {memory_, 1, raise_};
      const Value arguments = Value::tuple("(sm)", {nameOf(event), cycle});
      wire::encode(message.payload, arguments, rpc::Signature::of("(sm)"));
      const wire::Bytes frame = encodeFrame(message);
      posts.insert(posts.end(), frame.begin(), frame.end());
    }
    publisher_.send(posts);
  }

  void collect(Clock::time_point until) {
    std::vector<pollfd> polled;
    for (const auto& listener : listeners_) polled.push_back({listener->descriptor(), POLLIN, 0});
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    if (::poll(polled.data(), polled.size(), static_cast<int>(std::max<long>(0, left.count()))) <=
        0)
      return;
    for (std::size_t k = 0; k < polled.size(); ++k) {
      if ((polled[k].revents & POLLIN) == 0) continue;
      listeners_[k]->receiveSome();
      got_ += listeners_[k]->countMessages();
      ++pieces_;
    }
  }

  const WireServer& server_;
  WireClient publisher_;
  std::vector<std::unique_ptr<WireClient>> listeners_;
  std::uint32_t memory_ = 0;
  std::uint32_t raise_ = 0;
  std::size_t got_ = 0;
  std::size_t pieces_ = 0;
};

Value namesOf26(WireClient& client, std::uint32_t motion) {
  const auto get_names = client.method(motion, "getBodyNames", "(s)");
  return wire::Decoder(client.call({motion, 1, get_names}, Value::tuple({"Body"}))).read("[s]");
}

Value hundredKeys(const Value& joints) {
  std::vector<Value> keys;
  for (const char* what :
       {"Position/Sensor", "Position/Actuator", "ElectricCurrent/Sensor", "Temperature/Sensor"}) {
    for (const Value& joint : *joints.findItems()) {
      if (keys.size() == 100 || *joint.findText() == "RHipYawPitch") continue;
      keys.emplace_back("Device/SubDeviceList/" + *joint.findText() + "/" + what + "/Value");
    }
  }
  return Value::list(std::move(keys));
}

void run(const WireServer& server) {
  std::map<std::string, double> figures;
  WireClient client(server.port);
  const std::uint32_t motion = client.service("ALMotion");
  const std::uint32_t memory = client.service("ALMemory");
  const Value joints = namesOf26(client, motion);
  const wire::Address get_angles{motion, 1, client.method(motion, "getAngles", "(mb)")};
  const Value angles = Value::tuple("(mb)", {joints, true});
  const auto [call, echo] = compare(server, get_angles, angles);
  figures["call_p50_us"] = call.p50_us;
  figures["call_p99_us"] = call.p99_us;
  figures["echo_p50_us"] = echo.p50_us;
  figures["echo_p99_us"] = echo.p99_us;

  const wire::Address get_list{memory, 1, client.method(memory, "getListData", "(m)")};
  const auto [list, list_echo] =
      compare(server, get_list, Value::tuple("(m)", {hundredKeys(joints)}));
  figures["list_data_p50_us"] = list.p50_us;
  figures["list_data_echo_p50_us"] = list_echo.p50_us;

  const wire::Address ping{memory, 1, client.method(memory, "ping", "()")};
  std::vector<double> rates;
  for (int k = 0; k < 5; ++k) rates.push_back(pipelined(server, ping, Value::tuple({}), 200000));
  figures["calls_per_s"] = median(rates);
  figures["get_angles_calls_per_s"] = pipelined(server, get_angles, angles, 50000);
  EventStorm(server).run(figures);

  std::printf("{");
  const char* separator = "";
  for (const auto& [name, value] : figures) {
    std::printf("%s\"%s\": %.6g", std::exchange(separator, ", "), name.c_str(), value);
  }
  std::printf("}\n");
}

}  // namespace
}  // namespace nao::bench

int main() {
  const auto server = nao::bench::startWireServer();
  nao::bench::run(server);
  nao::bench::stopWireServer(server);
  return 0;
}
