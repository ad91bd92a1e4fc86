#include "src/cli/sunhours_surfaces.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/reading/scene_names.hpp"
#include "src/cli/report.hpp"
#include "src/cli/scene_hash.hpp"
#include "src/cli/sensor_rays.hpp"
#include "src/cli/surface_choice.hpp"
#include "src/cli/surface_files.hpp"
#include "src/cli/surface_results.hpp"
#include "src/hours/beam.hpp"
#include "src/hours/surfaces/division.hpp"
#include "src/hours/surfaces/left_out_cells.hpp"
#include "src/hours/surfaces/surface_part_file.hpp"
#include "src/hours/surfaces/windows.hpp"

#include <span>
#include <tuple>

namespace edgeshade::cli {
namespace {

/// Shares of the progress bar at which stages begin.
constexpr double raysFrom = 0.05, filesFrom = 0.95;

/// Distance from its plane that a window's pane may have, in metres.
constexpr double flatPane = 0.01;

hours::SurfaceCells divide(const SunHoursOptions& options, const LoadedScene& loaded,
                           const hours::SensorLight& light) {
    const SurfaceOptions& typed = options.surface;
    const double scale = 1.0 / typed.unit;
    const hours::SurfaceChoice choice =
        surfaceChoice(*loaded.document, typed.nodes, typed.materials, typed.windows);
    std::optional<double> rise = options.riseInWindows();
    if (rise) *rise *= scale;
    hours::SurfaceCells cells =
        typed.windows.empty()
            ? hours::cellsOf(loaded.scene, choice, {typed.grid * scale, typed.offset * scale})
            : hours::windowsOf(loaded.scene, choice, {flatPane * scale, typed.offset * scale, rise},
                               light);
    if (cells.cells.empty())
        throw Error(ExitStatus::usage, "--surfaces: there is no surface of that choice.");
    hours::markLeftOut(cells, hours::solidSurfaces(loaded.scene, loaded.settings.castMasked));
    return cells;
}

void addNames(const LoadedScene& loaded, hours::SurfaceRun& run) {
    for (const hours::WorldTriangle& triangle : run.cells.triangles) {
        if (!run.nodes.contains(triangle.node))
            run.nodes[triangle.node] = nodeTitle(*loaded.document, triangle.node);
        if (!run.materials.contains(triangle.material))
            run.materials[triangle.material] = materialTitle(*loaded.document, triangle.material);
    }
}

void requireSize(const hours::SurfacePart& part) {
    if (hours::bytesOfPart(part.run.cells, part.scene.size(), part.run.positions.size()) >
        hours::mostBytesOfPart)
        throw Error(ExitStatus::usage, "--part: " + std::to_string(part.run.cells.cells.size()) +
                                           " cells and " +
                                           std::to_string(part.run.positions.size()) +
                                           " sun positions would exceed 1 GiB; take more parts or "
                                           "a larger --grid.");
}

/// Writes a part's file; ends the bar.
void writePart(const SunHoursOptions& options, const hours::SurfacePart& part, ProgressBar& bar) {
    const std::string& path = options.files.picture;
    writeFile(path, std::string_view(hours::textOf(part)));
    bar.show(1.0, "done");
    printResult(path + ": part " + std::to_string(part.number) + " of " + std::to_string(part.of) +
                    ", " + std::to_string(part.run.cells.cells.size()) + " cells, " +
                    std::to_string(part.run.positions.size()) + " of " +
                    std::to_string(part.positionsOfRun) + " sun positions",
                "");
}

/// Throws Error(usage) for names that the files of a run, or its part, can't have.
void requireNames(const SunHoursOptions& options) {
    if (!options.part) {
        for (const std::string& path : options.files.all())
            surfaceFileOf(path);
        return;
    }
    if (!options.files.more.empty())
        throw Error(ExitStatus::usage,
                    "OUT: a part is one file; sunhours-merge writes the others.");
    if (isSurfaceFile(options.files.picture))
        throw Error(ExitStatus::usage, "OUT: '" + options.files.picture +
                                           "' is to be a part's file, which can't end in .glb, "
                                           ".csv or .npy; sunhours-merge writes these.");
}

} // namespace

void sunHoursOfSurfaces(const SunHoursOptions& options) {
    requireNames(options);
    if (options.by == SunHoursBy::masks)
        throw Error(ExitStatus::usage,
                    "--by masks does not go with --surfaces, which only rays can measure.");
    const hours::Schedule schedule = options.schedule();
    hours::SurfacePart part;
    std::tie(part.number, part.of) =
        options.part.value_or(std::pair<std::size_t, std::size_t>(1, 1));
    hours::SurfaceRun& run = part.run;
    run.positions = hours::positionsOf(schedule);
    run.step = schedule.step;
    run.offset = schedule.offset;
    run.unit = options.surface.unit;
    run.ofWindows = !options.surface.windows.empty();
    if (options.surface.quantity == Quantity::directKwh)
        part.beam = hours::beamOf(*options.weather, run.positions, run.step);

    const LoadedScene loaded = options.loadForHours(schedule, run.positions, true);
    ProgressBar bar;
    bar.show(0.0, "dividing surfaces");
    const hours::SensorLight light = sensorLight(loaded);
    run.cells = divide(options, loaded, light);
    addNames(loaded, run);
    run.settings = options.settingsJson(schedule, loaded.scene);
    run.settings["surfaces"] = options.surface.json();
    run.scene = hashOf(loaded.scene);
    run.version = EDGESHADE_VERSION;
    run.files = filesJson(*loaded.document, options.limits.fileBytes);
    run.warnings = loaded.scene.warnings.sentences();
    part.scene =
        hours::worldTriangles(loaded.scene, [](std::uint32_t, std::uint32_t) { return true; });
    part.positionsOfRun = run.positions.size();

    std::span<const double> beam = part.beam;
    const bool bits = options.part || keepsBits(options.files);
    if (options.part) {
        run.positions = hours::ofPart(run.positions, part.number, part.of);
        beam = {}; // merging sums the energy
        requireSize(part);
    } else {
        requireBitsFit(options.files, run.cells.cells.size(), run.positions.size());
    }
    const std::string doing = std::to_string(run.cells.cells.size()) + " cells, " +
                              std::to_string(run.positions.size()) + " sun positions";
    run.light = hours::lightOf(run.cells, hours::questionOf(run, schedule.days(), beam, bits),
                               light, [&](double share) {
                                   bar.show(raysFrom + (filesFrom - raysFrom) * share,
                                            "tracing rays to " + doing, "tracing rays to " + doing);
                               });
    bar.show(filesFrom, "making files");
    if (options.part)
        writePart(options, part, bar);
    else
        writeSurfaces(part, options.input, options.files, options.surface.when, bar);
}

} // namespace edgeshade::cli
