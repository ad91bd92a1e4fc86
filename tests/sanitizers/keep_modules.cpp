// Linked into every program of the asan preset. Drivers stay loaded to the end, so that the leak
// checker can tell by their names (lsan.supp) what is theirs.

extern "C" int dlclose(void* handle);

extern "C" int dlclose(void*) {
    return 0;
}
