#include "ci/judge.h"

namespace nao::ci {
namespace {

using Kind = When::Kind;
using std::chrono_literals::operator""ms;

constexpr Duration kPictures = 200ms;  // between two looks at pictures: they cost more than a beat

}  // namespace

Judge::Judge(const std::vector<Expectation>& expectations) {
  for (const Expectation& expectation : expectations)
    cases_.push_back({expectation, {}, {}, {}, {}, {}, {}});
}

void Judge::look(const Moment& moment) {
  for (Case& one : cases_) {
    if (!one.decided) lookAt(one, moment);
  }
}

void Judge::lookAt(Case& one, const Moment& moment) {
  const When& when = one.expectation.when;
  const Duration now = moment.now.time_since_epoch();
  if (now < (when.kind == Kind::At ? when.to : when.from)) return;
  if (when.kind != Kind::At && now > when.to) {
    if (when.kind == Kind::By) decide(one, false, one.best, one.at);
    return;
  }
  if (moment.now < one.next_look) return;
  if (std::holds_alternative<SeesBall>(one.expectation.condition)) {
    one.next_look = moment.now + kPictures;
  }
  const Observation seen = observer_.look(one.expectation.condition, moment);
  const bool first = !one.looked;
  one.looked = true;
  switch (when.kind) {
    case Kind::At:
      return decide(one, seen.holds, seen, now);
    case Kind::By:
      if (seen.holds) return decide(one, true, seen, now);
      break;
    case Kind::Always:
      if (!seen.holds) return decide(one, false, seen, now);
      break;
    case Kind::Never:
      if (seen.holds) return decide(one, false, seen, now);
      break;
  }
  if (!first && seen.off >= one.best.off) return;
  one.best = seen;
  one.at = now;
}

void Judge::decide(Case& one, bool passed, const Observation& seen, Duration at) {
  one.decided = true;
  one.passed = passed;
  one.best = seen;
  one.at = at;
  failed_ = failed_ || !passed;
}

std::vector<Verdict> Judge::finish(SimTime end) {
  std::vector<Verdict> verdicts;
  for (Case& one : cases_) {
    const When& when = one.expectation.when;
    const bool open_is_good = when.kind == Kind::Always || when.kind == Kind::Never;
    const bool covered = end.time_since_epoch() >= when.to;  // else the world ended before
    Verdict verdict;
    verdict.passed = one.decided ? one.passed : open_is_good && one.looked && covered;
    verdict.expected = one.expectation.text;
    verdict.line = one.expectation.line;
    verdict.at = one.at;
    verdict.seen = one.best.seen;
    if (!verdict.passed && when.kind == Kind::By && !verdict.seen.empty()) {
      verdict.seen = "closest: " + verdict.seen;
    }
    if (!one.decided && !covered) verdict.seen = "the world ended before that";
    if (!verdict.passed && verdict.seen.empty()) verdict.seen = "it did not happen";
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

}  // namespace nao::ci
