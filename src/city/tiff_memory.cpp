#include "src/city/tiff_memory.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace edgeshade::city {
namespace {

TiffMemory& memoryOf(thandle_t handle) {
    return *static_cast<TiffMemory*>(handle);
}

tmsize_t readSome(thandle_t handle, void* to, tmsize_t size) {
    TiffMemory& memory = memoryOf(handle);
    const std::size_t left = memory.bytes.size() - std::min(memory.at, memory.bytes.size());
    const std::size_t count = std::min(static_cast<std::size_t>(size), left);
    if (count > 0) std::memcpy(to, memory.bytes.data() + memory.at, count);
    memory.at += count;
    return static_cast<tmsize_t>(count);
}

tmsize_t writeNothing(thandle_t, void*, tmsize_t) {
    return 0;
}

toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
    TiffMemory& memory = memoryOf(handle);
    const std::size_t from = whence == SEEK_SET   ? 0
                             : whence == SEEK_CUR ? memory.at
                                                  : memory.bytes.size();
    memory.at = from + static_cast<std::size_t>(offset);
    return memory.at;
}

int close(thandle_t) {
    return 0;
}

toff_t sizeOf(thandle_t handle) {
    return memoryOf(handle).bytes.size();
}

/// Callers say what is wrong in one sentence of their own.
void silence() {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
}

} // namespace

TiffHandle openTiff(TiffMemory& memory) {
    silence();
    return TiffHandle(XTIFFClientOpen("memory", "r", &memory, readSome, writeNothing, seekTo, close,
                                      sizeOf, nullptr, nullptr));
}

TiffHandle createTiff(const std::filesystem::path& path, bool isBig) {
    silence();
    return TiffHandle(XTIFFOpen(path.c_str(), isBig ? "w8" : "w"));
}

} // namespace edgeshade::city
