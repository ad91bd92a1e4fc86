#include "src/cli/surface_files.hpp"

#include "preprocess/base/error.hpp"
#include "src/hours/surfaces/bits_npy.hpp"
#include "src/hours/surfaces/cells_csv.hpp"
#include "src/hours/surfaces/cells_glb.hpp"
#include "src/hours/surfaces/html_report.hpp"
#include "src/plot/color_scale.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::cli {
namespace {

/// The scale's colour as linear light.
glm::dvec3 linearColor(double share) {
    const plot::Color color = plot::evenColor(share);
    glm::dvec3 linear;
    for (glm::length_t c = 0; c < 3; ++c) {
        const double x = (color >> (16 - 8 * c) & 0xFF) / 255.0;
        linear[c] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
    return linear;
}

/// The value of the scale's end: the hours of a free point, or the most energy of any cell.
double mostOf(const hours::SurfaceRun& run) {
    double most = run.possibleHours();
    if (!run.light.directKwh.empty()) most = std::ranges::max(run.light.directKwh);
    return most > 0.0 ? most : 1.0;
}

Bytes bytesOf(std::string_view text) {
    return Bytes(text.begin(), text.end());
}

} // namespace

bool isSurfaceFile(const std::string& path) {
    return path.ends_with(".glb") || path.ends_with(".csv") || path.ends_with(".npy");
}

SurfaceFile surfaceFileOf(const std::string& path) {
    if (!isSurfaceFile(path))
        throw Error(ExitStatus::usage, "OUT: '" + path +
                                           "' ends neither in .glb nor .csv nor .npy, the files of "
                                           "--surfaces.");
    if (path.ends_with(".glb")) return SurfaceFile::glb;
    return path.ends_with(".csv") ? SurfaceFile::csv : SurfaceFile::npy;
}

MadeFile makeSurfaceFile(const std::string& path, const hours::SurfaceRun& run, bool when) {
    switch (surfaceFileOf(path)) {
    case SurfaceFile::glb:
        return {path, hours::glbOf(run, linearColor, mostOf(run))};
    case SurfaceFile::csv:
        return {path, bytesOf(hours::csvOf(run, {when}))};
    default:
        return {path, hours::npyOf(run)};
    }
}

bool isPage(const std::string& reportPath) {
    return reportPath.ends_with(".html");
}

MadeFile makePage(const std::string& path, const hours::SurfaceRun& run,
                  const hours::HoursSettings& settings, const nlohmann::ordered_json& report,
                  std::span<const hours::WorldTriangle> scene) {
    return {path,
            bytesOf(hours::htmlOf(run, settings, report, scene, {plot::evenColor, mostOf(run)}))};
}

} // namespace edgeshade::cli
