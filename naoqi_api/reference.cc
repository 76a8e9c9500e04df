#include "naoqi_api/reference.h"

#include <array>
#include <sstream>

namespace nao::rpc {
namespace {

constexpr std::uint32_t kFirstOwn = 113;  // below: what every object and every module has

const char* nameOf(Answer answer) {
  switch (answer) {
    case Answer::Done:
      return "done";
    case Answer::Simplified:
      return "simplified";
    case Answer::NotSimulated:
      return "not simulated";
  }
  return "";
}

constexpr char kPageHead[] =
    "# Which services are simulated\n\n"
    "Made by `usarnaoqi describe --services --markdown` from the declarations; a test keeps it\n"
    "current. `usarnaoqi describe --service NAME` tells the methods one by one.\n\n"
    "Every method of NAOqi 1.12 to 2.8 answers. **done**: as on a robot, in the simulated world.\n"
    "**simplified**: it keeps what it is told, takes its time and raises its events; what would\n"
    "come of it on a robot (people met, words recognised) does not happen. **not simulated**: an\n"
    "error that says so. Methods that all modules have (`ping`, `post`, `wait`, ...) are not "
    "counted.\n\n"
    "| service | done | simplified | not simulated |\n|---|---|---|---|\n";

bool isOwn(const Method& method) { return method.uid >= kFirstOwn && method.name != "wait"; }

struct Counts {
  std::array<int, 3> of{};  // by Answer
  int all() const { return of[0] + of[1] + of[2]; }
  void add(const Counts& other) {
    for (std::size_t i = 0; i < of.size(); ++i) of[i] += other.of[i];
  }
};

Counts countAnswers(const Service& service) {
  Counts counts;
  for (const auto& [uid, method] : service.methods()) {
    if (isOwn(method)) ++counts.of[static_cast<std::size_t>(method.answer)];
  }
  return counts;
}

std::string lineOf(const std::string& name, const Counts& counts) {
  std::ostringstream line;
  line << "| " << name << " | " << counts.of[0] << " | " << counts.of[1] << " | " << counts.of[2]
       << " |\n";
  return line.str();
}

std::string argumentList(const Method& method) {
  std::string list;
  for (const Argument& argument : method.arguments) {
    list += (list.empty() ? "" : ", ") + argument.name;
  }
  return list;
}

void tellMethod(const Method& method, std::ostream& out) {
  out << "  " << method.name << method.parameters_signature << " -> " << method.return_signature;
  if (method.answer != Answer::Done) out << "  [" << nameOf(method.answer) << "]";
  out << "\n";
  if (method.answer == Answer::NotSimulated) return;
  out << "      " << method.meaning << "\n";
  for (const Argument& argument : method.arguments) {
    out << "      " << argument.name << ": " << argument.meaning << "\n";
  }
}

// A cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter == '\n' ? ' ' : letter;
  }
  return escaped;
}

std::string quoted(const std::string& text) {
  std::string escaped = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') escaped += '\\';
    escaped += letter == '\n' ? ' ' : letter;
  }
  return escaped + "\"";
}

void addJson(const Method& method, std::ostream& out) {
  out << "{\"name\":" << quoted(method.name) << ",\"uid\":" << method.uid
      << ",\"parameters\":" << quoted(method.parameters_signature)
      << ",\"returns\":" << quoted(method.return_signature) << ",\"arguments\":[";
  for (std::size_t i = 0; i < method.arguments.size(); ++i) {
    out << (i == 0 ? "" : ",") << "{\"name\":" << quoted(method.arguments[i].name)
        << ",\"meaning\":" << quoted(method.arguments[i].meaning) << "}";
  }
  out << "],\"meaning\":" << quoted(method.meaning)
      << ",\"answer\":" << quoted(nameOf(method.answer)) << "}";
}

template <class Members>
void addJson(const char* kind, const Members& members, std::ostream& out) {
  out << ",\"" << kind << "\":[";
  bool first = true;
  for (const auto& [uid, member] : members) {
    out << (first ? "" : ",") << quoted(member.name);
    first = false;
  }
  out << "]";
}

void addJson(const Service& service, std::ostream& out) {
  out << "{\"name\":" << quoted(service.name()) << ",\"meaning\":" << quoted(service.meaning())
      << ",\"methods\":[";
  bool first = true;
  for (const auto& [uid, method] : service.methods()) {
    out << (first ? "" : ",");
    addJson(method, out);
    first = false;
  }
  out << "]";
  addJson("signals", service.signals(), out);
  addJson("properties", service.properties(), out);
  out << "}";
}

}  // namespace

std::string referenceText(const Service& service) {
  std::ostringstream out;
  out << service.name() << ": " << service.meaning() << "\n";
  for (const auto& [uid, method] : service.methods()) {
    if (isOwn(method)) tellMethod(method, out);
  }
  for (const auto& [uid, signal] : service.signals()) out << "  signal " << signal.name << "\n";
  for (const auto& [uid, property] : service.properties()) {
    out << "  property " << property.name << " " << property.signature << "\n";
  }
  return out.str();
}

std::string referenceMarkdown(const Service& service) {
  std::ostringstream out;
  out << "## " << service.name() << "\n\n" << service.meaning() << "\n\n";
  out << "| method | signature | answer | meaning |\n|---|---|---|---|\n";
  for (const auto& [uid, method] : service.methods()) {
    if (!isOwn(method)) continue;
    out << "| " << method.name << "(" << cell(argumentList(method)) << ") | `"
        << method.parameters_signature << method.return_signature << "` | " << nameOf(method.answer)
        << " | " << cell(method.meaning) << " |\n";
  }
  return out.str();
}

std::string coveragePage(const ServiceHub& hub) {
  std::string table = kPageHead;
  std::map<std::string, Counts> by_name;
  Counts sum;
  for (const auto& [id, entry] : hub.entries()) {
    if (!entry.service) continue;
    const Counts counts = countAnswers(*entry.service);
    if (counts.all() == 0) continue;
    by_name[entry.name] = counts;
    sum.add(counts);
  }
  for (const auto& [name, counts] : by_name) table += lineOf(name, counts);
  return table + lineOf("**all**", sum);
}

std::string referenceJson(const ServiceHub& hub, const std::string& only) {
  std::ostringstream out;
  out << "{\"services\":[";
  bool first = true;
  for (const auto& [id, entry] : hub.entries()) {
    if (!entry.service || (!only.empty() && entry.name != only)) continue;
    out << (first ? "" : ",\n");
    addJson(*entry.service, out);
    first = false;
  }
  out << "]}";
  return out.str();
}

}  // namespace nao::rpc
