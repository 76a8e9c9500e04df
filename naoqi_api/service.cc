#include "naoqi_api/service.h"

#include <algorithm>

#include "core/check.h"

namespace nao::rpc {
namespace {

bool isOneOf(char kind, std::string_view kinds) { return kinds.find(kind) != kinds.npos; }

// How far `given` is from a parameter of that type: the order libqi's scores give.
int distance(const Value& given, const Signature& parameter) {
  const std::string signature = given.bare().signature();
  const char from = signature.empty() ? 'v' : signature.front();
  const char to = parameter.kind();
  if (from == to) return 0;
  if (isOneOf(from, "cCwWiIlL") && isOneOf(to, "cCwWiIlL")) return 1;
  if (isOneOf(from, "fd") && isOneOf(to, "fd")) return 1;
  if (isOneOf(to, "fd")) return 4;
  if (isOneOf(from, "fd")) return 6;
  return to == 'b' ? 8 : 10;
}

constexpr int kAnything = 1000;  // further than any list of arguments of its own

// The sum over all arguments, or nothing if they can not be converted.
std::optional<int> distance(const Method& method, const std::vector<Value>& arguments) {
  const Signature& parameters = method.parameters;
  if (parameters.is('m')) return kAnything;
  if (!convert(Value::tuple(arguments), parameters, Bend::Declared)) return std::nullopt;
  int sum = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    sum += distance(arguments[i], parameters.children()[i]);
  }
  return sum;
}

}  // namespace

Service::Service(std::string name, std::string meaning)
    : name_(std::move(name)), meaning_(std::move(meaning)) {}

Service& Service::add(Method method) {
  for (const auto& [uid, known] : methods_) {
    NAO_CHECK(known.name != method.name ||
              known.parameters_signature != method.parameters_signature);
  }
  method.parameters = Signature::of(method.parameters_signature);
  method.returns = Signature::of(method.return_signature);
  NAO_CHECK(method.parameters.is('('));
  method.uid = takeUid();
  methods_.emplace(method.uid, std::move(method));
  return *this;
}

void Service::insert(Method method) {
  method.parameters = Signature::of(method.parameters_signature);
  method.returns = Signature::of(method.return_signature);
  const std::uint32_t uid = method.uid;
  methods_.emplace(uid, std::move(method));
}

void Service::insert(SignalMember signal) {
  const std::uint32_t uid = signal.uid;
  signals_.emplace(uid, std::move(signal));
}

void Service::insert(PropertyMember property) {
  const std::uint32_t uid = property.uid;
  properties_.emplace(uid, std::move(property));
}

Service& Service::addSignal(std::string name, Emitter emitter) {
  NAO_CHECK(Signature::of(emitter.signature()).is('('));
  const std::uint32_t uid = takeUid();
  signals_.emplace(uid, SignalMember{uid, std::move(name), std::move(emitter)});
  return *this;
}

Service& Service::signal(std::string name, std::string signature) {
  return addSignal(std::move(name), Emitter(std::move(signature)));
}

Service& Service::addProperty(PropertyMember property) {
  property.uid = takeUid();
  properties_.emplace(property.uid, std::move(property));
  return *this;
}

namespace {

template <class Members>
void move(Members& members, std::uint32_t from, std::uint32_t to) {
  auto node = members.extract(from);
  if (node.empty()) return;
  node.key() = to;
  node.mapped().uid = to;
  members.insert(std::move(node));
}

}  // namespace

void Service::moveMember(std::uint32_t from, std::uint32_t to) {
  move(methods_, from, to);
  move(signals_, from, to);
  move(properties_, from, to);
}

Service& Service::at(std::uint32_t uid) {
  NAO_CHECK(last_uid_ != 0 && uid >= kFirstUid);
  NAO_CHECK(given_uids_.insert(uid).second);
  if (uid == last_uid_) return *this;
  const std::uint32_t last = last_uid_;
  constexpr std::uint32_t kAside = 0;
  moveMember(last, kAside);
  next_uid_ = std::min(next_uid_, last);
  if (!isFree(uid)) moveMember(uid, takeUid());
  moveMember(kAside, uid);
  last_uid_ = uid;
  return *this;
}

Service& Service::returning(std::string signature, std::string meaning) {
  const auto method = methods_.find(last_uid_);
  NAO_CHECK(method != methods_.end());
  method->second.setReturns(std::move(signature));
  method->second.return_meaning = std::move(meaning);
  return *this;
}

Service& Service::answering(Answer answer) {
  methods_.at(last_uid_).answer = answer;
  return *this;
}

Service& Service::allAnswering(Answer answer) {
  constexpr std::uint32_t kFirstOwn = 113;  // below: what every NaoQi module has
  for (auto& [uid, method] : methods_) {
    if (uid >= kFirstOwn) method.answer = answer;
  }
  return *this;
}

void Service::removeMethods(const std::set<std::string>& names) {
  for (auto method = methods_.begin(); method != methods_.end();) {
    method = names.count(method->second.name) > 0 ? methods_.erase(method) : std::next(method);
  }
}

Service& Service::startAt(std::uint32_t uid) {
  next_uid_ = uid;
  return *this;
}

Service& Service::owning(std::shared_ptr<void> implementation) {
  owned_.push_back(std::move(implementation));
  return *this;
}

const Method* Service::findMethod(std::uint32_t uid) const {
  const auto found = methods_.find(uid);
  return found == methods_.end() ? nullptr : &found->second;
}

const Emitter* Service::findSignal(std::uint32_t uid) const {
  const auto signal = signals_.find(uid);
  if (signal != signals_.end()) return &signal->second.emitter;
  const PropertyMember* property = findProperty(uid);
  return property ? &property->emitter : nullptr;
}

const Emitter* Service::findSignal(std::string_view name) const {
  for (const auto& [uid, signal] : signals_) {
    if (signal.name == name) return &signal.emitter;
  }
  const PropertyMember* property = findProperty(name);
  return property ? &property->emitter : nullptr;
}

const PropertyMember* Service::findProperty(std::uint32_t uid) const {
  const auto found = properties_.find(uid);
  return found == properties_.end() ? nullptr : &found->second;
}

const PropertyMember* Service::findProperty(std::string_view name) const {
  for (const auto& [uid, property] : properties_) {
    if (property.name == name) return &property;
  }
  return nullptr;
}

const Method* Service::findMethod(std::string_view name,
                                  const std::vector<Value>& arguments) const {
  const Method* best = nullptr;
  std::optional<int> least;
  for (const auto& [uid, method] : methods_) {
    if (method.name != name) continue;
    const bool fits_count = method.parameters.children().size() == arguments.size();
    if (!fits_count && !method.parameters.is('m')) continue;
    const auto away = distance(method, arguments);
    if (!best || (away && (!least || *away < *least))) {
      best = &method;
      least = away;
    }
  }
  return best;
}

Pending<Value> Service::call(std::string_view name, const std::vector<Value>& arguments,
                             Caller caller) {
  caller.service = this;
  if (const Method* method = findMethod(name, arguments)) return method->invoke(caller, arguments);
  Pending<Value> failed;
  failed.fail("\t" + name_ + "::" + std::string(name) + "\n\tCan't find method: " +
              std::string(name) + " (resolved to '" + Value::tuple(arguments).signature() + "')");
  return failed;
}

void Service::emit(std::string_view signal, const std::vector<Value>& arguments) const {
  for (const auto& [uid, member] : signals_) {
    if (member.name == signal) return member.emitter.emit(arguments);
  }
  NAO_CHECK(!"a signal of this name");
}

bool Service::isFree(std::uint32_t uid) const {
  return methods_.count(uid) + signals_.count(uid) + properties_.count(uid) == 0;
}

std::uint32_t Service::takeUid() {
  while (!isFree(next_uid_)) ++next_uid_;
  last_uid_ = next_uid_++;
  return last_uid_;
}

}  // namespace nao::rpc
