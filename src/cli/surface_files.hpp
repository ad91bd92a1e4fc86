#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/hours/surfaces/surface_run.hpp"

#include <string>
#include <vector>

namespace edgeshade::cli {

/// Kinds of files of surfaces, by the ends of their names.
enum class SurfaceFile { glb, csv, npy };

/// Throws Error(usage) for any other end, naming OUT.
SurfaceFile surfaceFileOf(const std::string& path);

/// A file to be written.
struct MadeFile {
    std::string path;
    Bytes bytes;
};

/// The file's bytes. `when`: tables have the first and last time. Throws Error(output) for what its
/// format can't hold.
MadeFile makeSurfaceFile(const std::string& path, const hours::SurfaceRun& run, bool when);

} // namespace edgeshade::cli
