#pragma once

/// Marks what the shared library shows to programs; all else in it is hidden.
#define USARNAOQI_SDK_API __attribute__((visibility("default")))
