#pragma once

// Sound modules include it and use nothing of it but what it brings along. What it declared itself
// is documented nowhere in public, so that is missing; a program that measures time by it does not
// compile.
#include <math.h>
