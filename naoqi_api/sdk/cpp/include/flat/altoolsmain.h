#pragma once

// The place of NAOqi 1.x.
#include <alcommon/altoolsmain.h>
