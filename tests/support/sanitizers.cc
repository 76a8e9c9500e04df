/// Read by the leak sanitizer, where there is one. urdfdom keeps what it had parsed of a URDF that
/// turns out to be broken: its links and joints own each other.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: its name is the sanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:liburdfdom_model\n"; }

/// Read by the address sanitizer, where there is one: it keeps no more freed memory [MB] than tests
/// that measure how much their process holds allow for.
extern "C" const char* __asan_default_options();  // NOLINT: its name is the sanitizer's
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=4"; }
