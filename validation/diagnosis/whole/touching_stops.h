#pragma once

#include "validation/diagnosis/causes/whole_causes.h"
#include "validation/diagnosis/replay/whole_simulator.h"

namespace nao::validation {

/// Of a coupled stop: its starts are lines that just touch what was measured in the runs to fit
/// (touched_lines.h).
void startWhereTouched(PlacedCause& coupled, const WholeSimulator& simulator);

}  // namespace nao::validation
