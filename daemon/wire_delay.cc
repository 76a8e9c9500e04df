#include "daemon/wire_delay.h"

#include <algorithm>
#include <utility>

namespace nao::daemon {

/// One client's stream. What waits keeps it alive.
class WireDelay::Held final : public Stream {
 public:
  Held(WireDelay& wire, std::unique_ptr<Stream> inner)
      : state_(std::make_shared<State>(State{wire, std::move(inner), {}, {}, false})) {}
  ~Held() override { close(); }

  void open(Done done) override { state_->inner->open(std::move(done)); }

  void read(Got got) override {
    state_->inner->read([state = state_, got = std::move(got)](
                            const Error& error, const std::uint8_t* bytes, std::size_t count) {
      const SimTime at = state->next(state->last_in);
      if (error || at <= state->wire.now_) return got(error, bytes, count);
      state->wire.later(at, [state, got, held = rpc::Bytes(bytes, bytes + count)] {
        if (!state->closed) got({}, held.data(), held.size());
      });
    });
  }

  void write(const rpc::Bytes& bytes, Done done) override {
    const SimTime at = state_->next(state_->last_out);
    if (at <= state_->wire.now_) return state_->inner->write(bytes, std::move(done));
    state_->wire.later(at, [state = state_, &bytes, done = std::move(done)] {
      if (!state->closed) state->inner->write(bytes, done);
    });
  }

  void close() override {
    if (std::exchange(state_->closed, true)) return;
    state_->inner->close();
  }
  bool isOpen() const override { return state_->inner->isOpen(); }
  std::string endpoint() const override { return state_->inner->endpoint(); }

 private:
  struct State {
    SimTime next(SimTime& last) { return last = wire.arrival(last); }

    WireDelay& wire;
    std::unique_ptr<Stream> inner;
    SimTime last_in, last_out;  // when the newest packet arrives
    bool closed;
  };
  std::shared_ptr<State> state_;
};

std::unique_ptr<Stream> WireDelay::over(std::unique_ptr<Stream> inner) {
  return std::make_unique<Held>(*this, std::move(inner));
}

SimTime WireDelay::arrival(SimTime earliest) {
  SimTime at = now_;
  if (fault_.until > now_) {
    at += fault_.delay;
    for (Duration again = kAgain; random_.uniform() < fault_.loss; again *= 2) at += again;
  }
  return std::max(at, earliest);
}

// What is done may send more, which is not due before the next time.
void WireDelay::advance(SimTime now) {
  now_ = now;
  while (!jobs_.empty() && jobs_.begin()->first <= now) {
    const auto job = std::move(jobs_.begin()->second);
    jobs_.erase(jobs_.begin());
    job();
  }
}

}  // namespace nao::daemon
