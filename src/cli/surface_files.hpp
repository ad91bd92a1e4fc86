#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/hours/settings.hpp"
#include "src/hours/surfaces/surface_run.hpp"

#include <string>
#include <vector>

namespace edgeshade::cli {

/// Kinds of files of surfaces, by the ends of their names.
enum class SurfaceFile { glb, csv, npy };

/// Whether the name ends as one of them.
bool isSurfaceFile(const std::string& path);

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

/// Whether a report of that name is a page.
bool isPage(const std::string& reportPath);

/// The report as a page; see hours::htmlOf(). `scene`: all triangles.
MadeFile makePage(const std::string& path, const hours::SurfaceRun& run,
                  const hours::HoursSettings& settings, const nlohmann::ordered_json& report,
                  std::span<const hours::WorldTriangle> scene);

} // namespace edgeshade::cli
