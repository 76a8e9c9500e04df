#include "bench/event_storm.h"

#include <sys/epoll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "naoqi_api/wire/codec.h"

namespace nao::bench {
namespace {

using rpc::Value;

std::string nameOf(int event) { return "Storm/" + std::to_string(event); }

}  // namespace

EventStorm::EventStorm(const WireServer& server)
    : server_(server), publisher_(server.port), all_(::epoll_create1(0)) {
  memory_ = publisher_.service("ALMemory");
  raise_ = publisher_.method(memory_, "raiseEvent", "(sm)");
  const auto subscriber = publisher_.method(memory_, "subscriber", "(s)");
  for (int k = 0; k < kListeners; ++k) {
    listeners_.push_back(std::make_unique<WireClient>(server.port));
    for (int event = 0; event < kEvents; ++event) listen(*listeners_.back(), subscriber, event);
    epoll_event wanted{};
    wanted.events = EPOLLIN;
    wanted.data.u32 = static_cast<std::uint32_t>(k);
    if (::epoll_ctl(all_, EPOLL_CTL_ADD, listeners_.back()->descriptor(), &wanted) != 0)
      std::abort();
  }
}

EventStorm::~EventStorm() { ::close(all_); }

void EventStorm::run(std::map<std::string, double>& figures) {
  const ServerWatch unloaded(server_);
  pass(false);
  figures["unloaded_server_cpu_percent"] = unloaded.cpuPercent();
  figures["unloaded_lateness_p99_ms"] = unloaded.latenessP99Ms();
  const ServerWatch loaded(server_);
  pass(true);
  figures["events_server_cpu_percent"] = loaded.cpuPercent();
  figures["events_lateness_p99_ms"] = loaded.latenessP99Ms();
  const auto end = Clock::now() + std::chrono::seconds(2);
  while (Clock::now() < end) collect(end);
  constexpr double kAll = double{kListeners} * kEvents * kCycles;
  figures["events_sent"] = kAll;
  figures["events_lost"] = kAll - static_cast<double>(got_);
  figures["events_pieces_per_cycle_and_listener"] =
      static_cast<double>(pieces_) / (double{kListeners} * kCycles);
}

// As long with events as without.
void EventStorm::pass(bool raising) {
  const auto start = Clock::now();
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    if (raising) raiseAll(cycle);
    const auto next = start + std::chrono::milliseconds(20) * (cycle + 1);
    while (Clock::now() < next) collect(next);
  }
}

void EventStorm::listen(WireClient& client, std::uint32_t subscriber, int event) const {
  const wire::Bytes object = client.call({memory_, 1, subscriber}, Value::tuple({nameOf(event)}));
  wire::Decoder decoder(object);
  const Value offer = decoder.read("({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)");
  const auto service = decoder.number<std::uint32_t>();
  const auto number = decoder.number<std::uint32_t>();
  const auto& signals = offer.findItems()->at(1).find<Value::Map>()->entries;
  const auto signal = *signals.back().first.find<std::uint32_t>();
  client.call({service, number, 0}, Value::tuple({service, signal, std::uint64_t{1}}));
}

void EventStorm::raiseAll(int cycle) {
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

// What has come to any of them; waits for it, at most until then.
void EventStorm::collect(Clock::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
  epoll_event ready[kListeners];
  const int count =
      ::epoll_wait(all_, ready, kListeners, static_cast<int>(std::max<long>(0, left.count())));
  for (int k = 0; k < count; ++k) {
    WireClient& listener = *listeners_[ready[k].data.u32];
    listener.receiveSome();
    got_ += listener.countMessages();
    ++pieces_;
  }
}

}  // namespace nao::bench
