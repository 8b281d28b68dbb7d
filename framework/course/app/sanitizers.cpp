// The options of the sanitizers in check-NN. They call these functions by name.

// Memory is not looked at for leaks: the process may end at any time. Vectors that grow in code without sanitizers look
// like faults to detect_container_overflow. Freed memory is watched until 4 MB more are freed: with the usual 256 MB,
// each of a check's many images takes new pages, which is a third of its time.
extern "C" const char* __asan_default_options();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() {  // NOLINT(bugprone-reserved-identifier)
    return "detect_leaks=0:detect_container_overflow=0:halt_on_error=0:handle_abort=1:print_legend=0:color=never:"
           "hard_rss_limit_mb=4096:quarantine_size_mb=4";
}

extern "C" const char* __ubsan_default_options();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __ubsan_default_options() {  // NOLINT(bugprone-reserved-identifier)
    return "color=never";
}
