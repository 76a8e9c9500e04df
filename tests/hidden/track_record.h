#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/verdict_record.h"

namespace nao::hidden {

/// What the statements in lines of results.jsonl came to, by their kind and by the engine that made
/// the set; lines of sets with spoilt data count for nothing. @throws InputError for a line that is
/// none.
validation::VerdictRecords trackRecord(const std::vector<std::string>& lines);

/// The file that `usarnaoqi diagnose --record` reads: the record and what it was made of.
std::string toYaml(const std::vector<std::string>& lines);

}  // namespace nao::hidden
