#pragma once

// The place of NAOqi 1.x.
#include <alvision/alvisiondefinitions.h>
