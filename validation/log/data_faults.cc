#include "validation/log/data_faults.h"

#include <algorithm>
#include <cmath>

#include "validation/log/fault_checks.h"
#include "validation/log/series.h"

namespace nao::validation {
namespace {

// A kind of fault in nearly all joints is one fault of the whole set; free choice.
constexpr double kNearlyAll = 0.8;

std::string columnOf(const FaultLog::Entry& entry) {
  return entry.signal.empty() ? entry.joint : entry.signal + "." + entry.joint;
}

DataFault describe(const FaultLog::Entry& entry, std::size_t runs, std::size_t joints) {
  DataFault fault{entry.kind, entry.note, entry.file, columnOf(entry), entry.row, {}};
  std::string& text = fault.sentence;
  if (!entry.file.empty()) text += entry.file + ": ";
  if (entry.row) text += "row " + std::to_string(*entry.row) + ": ";
  if (!fault.column.empty()) text += fault.column + ": ";
  text += entry.text;
  if (runs > 1) text += ", and so in " + std::to_string(runs - 1) + " more runs";
  if (joints > 1) {
    text += ", and so for " + std::to_string(joints - 1) + " more joints";
    fault.column.clear();
  }
  return fault;
}

}  // namespace

const char* nameOf(DataFaultKind kind) {
  switch (kind) {
    case DataFaultKind::Clock:
      return "clock";
    case DataFaultKind::Gap:
      return "gap";
    case DataFaultKind::Rate:
      return "rate";
    case DataFaultKind::Duplicates:
      return "duplicates";
    case DataFaultKind::Quantum:
      return "quantum";
    case DataFaultKind::Offset:
      return "offset";
    case DataFaultKind::Swapped:
      return "swapped";
    case DataFaultKind::Negated:
      return "negated";
    case DataFaultKind::Unrelated:
      return "unrelated";
    case DataFaultKind::Units:
      return "units";
    case DataFaultKind::Constant:
      return "constant";
    case DataFaultKind::Misaligned:
      return "misaligned";
    case DataFaultKind::Copied:
      return "copied";
    case DataFaultKind::Split:
      return "split";
  }
  return "";
}

std::vector<DataFault> FaultLog::merge(std::size_t joints) const {
  struct Group {
    const Entry* first;
    std::size_t runs;
  };
  using Kind = std::pair<DataFaultKind, bool>;
  std::map<Kind, std::vector<Group>> groups;  // of one kind: by column, in order of finding
  for (const Entry& entry : entries_) {
    std::vector<Group>& of_kind = groups[{entry.kind, entry.note}];
    const auto same = std::find_if(of_kind.begin(), of_kind.end(), [&](const Group& group) {
      return columnOf(*group.first) == columnOf(entry);
    });
    if (same == of_kind.end()) {
      of_kind.push_back({&entry, 1});
    } else {
      ++same->runs;
    }
  }
  std::vector<DataFault> faults;
  for (const auto& [kind, of_kind] : groups) {
    const auto most = kNearlyAll * static_cast<double>(joints);
    if (of_kind.size() > 1 && static_cast<double>(of_kind.size()) >= most) {
      faults.push_back(describe(*of_kind.front().first, of_kind.front().runs, of_kind.size()));
      continue;
    }
    for (const Group& group : of_kind) faults.push_back(describe(*group.first, group.runs, 1));
  }
  return faults;
}

SetSeries resampleAll(const LogSet& set, double dt) {
  SetSeries all;
  for (const LogRun& run : set.runs) {
    std::vector<JointSeries>& of_run = all.emplace_back(set.joints.size());
    for (std::size_t j = 0; j < set.joints.size(); ++j) {
      const std::string& name = set.joints[j].name;
      JointSeries& series = of_run[j];
      if (const Column* c = run.find("cmd." + name)) series.command = resample(run.t, *c, dt);
      if (const Column* q = run.find("q." + name)) series.sensor = resample(run.t, *q, dt);
      if (const Column* s = run.find("cmd_stiffness." + name)) {
        constexpr double kOn = 0.05;
        for (const double x : resample(run.t, *s, dt)) series.stiff.push_back(x > kOn);
        series.stiff.resize(series.sensor.size(), true);
      }
    }
  }
  return all;
}

namespace {

// Degrees make an encoder's step look coarse: one fault, told once.
void dropConsequences(std::vector<DataFault>& faults) {
  const auto in_degrees = [&faults](const DataFault& fault) {
    return fault.kind == DataFaultKind::Quantum &&
           std::any_of(faults.begin(), faults.end(), [&fault](const DataFault& other) {
             return other.kind == DataFaultKind::Units &&
                    (other.column == fault.column || other.column.empty());
           });
  };
  std::vector<DataFault> kept;
  for (const DataFault& fault : faults) {
    if (!in_degrees(fault)) kept.push_back(fault);
  }
  faults = std::move(kept);
}

}  // namespace

std::vector<DataFault> findDataFaults(const LogSet& set, const RobotModel* model) {
  FaultLog log;
  checkTimes(set, log);
  const Quanta quanta = findQuanta(set);
  checkQuanta(set, model, quanta, log);
  checkDuplicates(set, quanta, log);
  checkConstants(set, log);
  checkUnits(set, model, log);
  const double dt = 1 / set.rate;
  const SetSeries series = resampleAll(set, dt);
  checkJointMap(set, series, dt, log);
  checkOffsets(set, series, dt, log);
  checkRepeats(set, series, dt, log);
  checkCopies(set, log);
  checkSplits(set, log);
  std::vector<DataFault> faults = log.merge(set.joints.size());
  dropConsequences(faults);
  return faults;
}

bool anyFault(const std::vector<DataFault>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const DataFault& f) { return !f.note; });
}

bool isOneCoarseEncoder(const DataFault& fault) {
  return fault.kind == DataFaultKind::Quantum && !fault.column.empty();
}

Report reportDataFaults(const LogSet& set, const std::vector<DataFault>& findings) {
  Report report;
  report.command = "check-data";
  report.robot = set.robot;
  report.runs = static_cast<int>(set.runs.size());
  std::vector<Row> rows;
  TextTable table{"Findings in " + set.name, {"kind", "what"}, {}};
  double faults = 0;
  for (const DataFault& fault : findings) {
    if (!fault.note) ++faults;
    const std::string weight = fault.note ? "note" : "fault";
    Row row{{"kind", std::string(nameOf(fault.kind))}, {"weight", weight}};
    row.push_back({"file", fault.file});
    row.push_back({"column", fault.column});
    if (fault.row) row.push_back({"row", static_cast<double>(*fault.row)});
    row.push_back({"sentence", fault.sentence});
    rows.push_back(std::move(row));
    table.lines.push_back(
        {nameOf(fault.kind) + std::string(fault.note ? " (note)" : ""), fault.sentence});
  }
  report.figures = {{"faults", faults}, {"findings", rows}};
  if (!table.lines.empty()) report.tables.push_back(std::move(table));
  report.remarks.push_back(faults > 0 ? "The data have faults: mend them before any diagnosis."
                                      : "No fault was found in the data.");
  return report;
}

}  // namespace nao::validation
