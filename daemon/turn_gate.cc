#include "daemon/turn_gate.h"

#include <algorithm>
#include <utility>

namespace nao::daemon {
namespace {

constexpr std::size_t kMostWaiting = 64U << 20U;  // of bytes in front of one session

}  // namespace

/// One client's socket. What it still does keeps it alive.
struct TurnGate::Flow : std::enable_shared_from_this<Flow> {
  Flow(TurnGate& g, std::unique_ptr<Stream> s, std::uint16_t from, std::uint16_t to)
      : gate(g), inner(std::move(s)), from_port(from), to_port(to) {}

  void pump() {
    if (pumping || error || is_closed || waiting.size() > kMostWaiting) return;
    pumping = true;
    inner->read([self = shared_from_this()](const Stream::Error& failed, const std::uint8_t* bytes,
                                            std::size_t count) {
      self->pumping = false;
      self->error = failed;
      self->received += count;
      self->waiting.insert(self->waiting.end(), bytes, bytes + count);
      self->pump();
    });
  }

  bool hand() {
    if (!got || (waiting.empty() && !error)) return false;
    const Stream::Got to = std::exchange(got, {});
    const rpc::Bytes bytes = std::exchange(waiting, {});
    to(bytes.empty() ? error : Stream::Error{}, bytes.data(), bytes.size());
    pump();
    return true;
  }

  TurnGate& gate;
  std::unique_ptr<Stream> inner;
  std::uint16_t from_port, to_port;
  Stream::Got got;
  rpc::Bytes waiting;
  std::uint64_t received = 0;
  Stream::Error error;  // of its end
  bool pumping = false;
  bool is_closed = false;
};

class TurnGate::Guarded final : public Stream {
 public:
  explicit Guarded(std::shared_ptr<Flow> flow) : flow_(std::move(flow)) {}
  ~Guarded() override { close(); }

  void open(Done done) override { flow_->inner->open(std::move(done)); }
  void read(Got got) override {
    flow_->got = std::move(got);
    flow_->pump();
  }
  // Counted when it begins: what the socket has no place for follows while the client reads.
  void write(const rpc::Bytes& bytes, Done done) override {
    flow_->gate.count(*flow_, bytes.size());
    flow_->inner->write(
        bytes, [flow = flow_, done = std::move(done)](const Error& failed) { done(failed); });
  }
  void close() override {
    if (std::exchange(flow_->is_closed, true)) return;
    flow_->inner->close();
    flow_->got = {};
    flow_->gate.leave(flow_);
  }
  bool isOpen() const override { return flow_->inner->isOpen(); }
  std::string endpoint() const override { return flow_->inner->endpoint(); }

 private:
  std::shared_ptr<Flow> flow_;
};

std::unique_ptr<Stream> TurnGate::guard(std::unique_ptr<Stream> inner, std::uint16_t from_port,
                                        std::uint16_t to_port) {
  flows_.push_back(std::make_shared<Flow>(*this, std::move(inner), from_port, to_port));
  return std::make_unique<Guarded>(flows_.back());
}

clock::Link* TurnGate::linkOf(const Flow& flow) {
  for (clock::Link& link : page_.links) {
    const std::uint32_t used = link.used.load();
    if (used != clock::kLinkOpen && used != clock::kLinkClosed) continue;
    if (link.from_port == flow.from_port && link.to_port == flow.to_port) return &link;
  }
  return nullptr;
}

TurnGate::Flow* TurnGate::flowOf(const clock::Link& link) {
  for (const auto& flow : flows_)
    if (link.from_port == flow->from_port && link.to_port == flow->to_port) return flow.get();
  return nullptr;
}

void TurnGate::count(const Flow& flow, std::size_t bytes) {
  given_ += bytes;
  if (clock::Link* link = linkOf(flow)) link->given += bytes;
}

bool TurnGate::isComplete(clock::Link& link) {
  const std::uint32_t used = link.used.load();
  if (used != clock::kLinkOpen && used != clock::kLinkClosed) return true;
  const Flow* flow = flowOf(link);
  if (used == clock::kLinkOpen) return flow && flow->received >= link.sent.load();
  if (flow) return static_cast<bool>(flow->error);
  link.used = clock::kLinkFree;
  return true;
}

bool TurnGate::hasAll() {
  return std::all_of(std::begin(page_.links), std::end(page_.links),
                     [this](clock::Link& link) { return isComplete(link); });
}

bool TurnGate::open() {
  bool any = false;
  const auto flows = flows_;  // sessions that end leave the list meanwhile
  for (const auto& flow : flows) any |= flow->hand();
  return any;
}

void TurnGate::leave(const std::shared_ptr<Flow>& flow) {
  if (clock::Link* link = linkOf(*flow)) {
    std::uint32_t open = clock::kLinkOpen;
    if (!link->used.compare_exchange_strong(open, clock::kLinkClosedByWorld))
      link->used = clock::kLinkFree;
  }
  flows_.erase(std::remove(flows_.begin(), flows_.end(), flow), flows_.end());
}

}  // namespace nao::daemon
