/// Read by the leak sanitizer, where there is one. urdfdom keeps what it had parsed of a URDF that
/// turns out to be broken: its links and joints own each other.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: its name is the sanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:liburdfdom_model\n"; }
