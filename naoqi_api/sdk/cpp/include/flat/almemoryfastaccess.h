#pragma once

// The place of NAOqi 1.x.
#include <almemoryfastaccess/almemoryfastaccess.h>
