// Linked into every program of the asan preset: what the sanitizers have to know, wherever it is
// run.

extern "C" {

int dlclose(void* handle);
const char* __asan_default_options();
const char* __lsan_default_options();
const char* __lsan_default_suppressions();

/// Drivers stay loaded to the end, so that the leak checker can tell by their names what is theirs.
int dlclose(void*) {
    return 0;
}

/// GCC 12's runtime takes 16 bytes past a page for the header of glibc 2.19's thread-local storage,
/// reads a size there that isn't one, and the leak checker then scans memory that isn't there
/// ("Tracer caught signal 11"). Behind red zones of 256 bytes every block begins at a multiple
/// of 64. What nothing was written to is filled with ones, which suit hardly any reader.
const char* __asan_default_options() {
    return "redzone=256:max_malloc_fill_size=65536:malloc_fill_byte=255";
}

const char* __lsan_default_options() {
    return "print_suppressions=0";
}

/// Not the program's: what Mesa, LLVM and fontconfig keep for themselves.
const char* __lsan_default_suppressions() {
    return "leak:swrast_dri.so\n"
           "leak:libgallium\n"
           "leak:libLLVM\n"
           "leak:libEGL_mesa\n"
           "leak:libfontconfig\n";
}

} // extern "C"
