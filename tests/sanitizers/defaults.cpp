// Linked into every program of the asan preset: the sanitizers' options, wherever a program runs.

extern "C" {

int dlclose(void* handle);
const char* __asan_default_options();
const char* __lsan_default_options();
const char* __lsan_default_suppressions();

/// Keeps drivers loaded to the end, so that the leak checker can recognise their leaks by name.
int dlclose(void*) {
    return 0;
}

/// GCC 12's runtime mistakes 16 bytes past a page for the header of glibc 2.19's thread-local
/// storage and reads an invalid size there; the leak checker then scans unmapped memory ("Tracer
/// caught signal 11"). Behind red zones of 256 bytes every block begins at a multiple of 64.
/// Unwritten memory is filled with ones, which few readers accept.
const char* __asan_default_options() {
    return "redzone=256:max_malloc_fill_size=65536:malloc_fill_byte=255";
}

const char* __lsan_default_options() {
    return "print_suppressions=0";
}

/// Not the program's leaks: memory that Mesa, LLVM and fontconfig keep for themselves.
const char* __lsan_default_suppressions() {
    return "leak:swrast_dri.so\n"
           "leak:libgallium\n"
           "leak:libLLVM\n"
           "leak:libEGL_mesa\n"
           "leak:libfontconfig\n";
}

} // extern "C"
