#include "preprocess/base/error.hpp"
#include "preprocess/mesh/topology.hpp"
#include "preprocess/reading/scene_names.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/report.hpp"
#include "src/cli/scene_hash.hpp"
#include "src/cli/sunhours_files.hpp"
#include "src/cli/sunhours_options.hpp"
#include "src/cli/sunhours_surfaces.hpp"
#include "src/cli/sunhours_way.hpp"
#include "src/gl/headless_context.hpp"
#include "src/hours/part_file.hpp"
#include "src/lab/pixel_surfaces.hpp"
#include "src/lab/sun_counts.hpp"
#include "src/lab/sun_probe.hpp"
#include "src/lab/texture_alpha.hpp"
#include "src/render/accumulation/direction_counts.hpp"
#include "src/shadow/view/plan_view.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <memory>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Shares of the progress bar: of measuring surfaces, and of counting.
constexpr double surfacesShare = 0.1, countingShare = 0.85;

Json cameraJson(const Frustum& frustum) {
    Json camera = {{"matrix", std::vector<double>(glm::value_ptr(frustum.viewFromWorld),
                                                  glm::value_ptr(frustum.viewFromWorld) + 16)}};
    if (frustum.orthographic)
        camera["ortho"] = frustum.size().y;
    else
        camera["fov"] = glm::degrees(2.0 * std::atan(0.5 * frustum.size().y));
    return camera;
}

FrameRequest requestOf(const SunHoursOptions& options, const Scene& scene) {
    FrameRequest request = requestFor(options.view, scene);
    if (options.plan) request.frustum = planView(scene, options.view.aspect(), options.typed.north);
    return request;
}

std::vector<glm::dvec3> directionsOf(const std::vector<hours::Position>& positions) {
    std::vector<glm::dvec3> directions;
    for (const hours::Position& position : positions)
        directions.push_back(position.direction);
    return directions;
}

std::string countingText(std::size_t positions) {
    return "counting " + std::to_string(positions) + " sun positions";
}

LitCounts countLit(const SunHoursOptions& options, const LoadedScene& loaded,
                   const FrameRequest& request, const std::vector<glm::dvec3>& directions,
                   ProgressBar& bar) {
    const gl::HeadlessContext context({request.width, request.height, 0, options.glLimits});
    DrawSettings draw;
    draw.render.shading = Shading::base;
    resolve(draw);
    draw.render.layout = layoutFor(InstancingChoice::automatic, context.capabilities());
    Renderer renderer(draw.render, context.capabilities());
    GpuScene scene = uploadScene(loaded, draw.render.records(), context.capabilities());
    return countDirections(
        loaded, request, directions, renderer, scene, context.capabilities(), [&](double share) {
            bar.show(surfacesShare + countingShare * share, countingText(directions.size()));
        });
}

/// The node that cut faces of a section count as; no file has so many nodes.
constexpr std::uint32_t fillNode = hours::Exposure::none - 1;

lab::Question questionOf(const LoadedScene& loaded, const FrameRequest& request) {
    const FrameView view = makeFrameView(loaded.scene, request, worldBounds(loaded.scene));
    lab::Question question;
    question.scene = &loaded.scene;
    question.castMasked = loaded.settings.castMasked;
    question.cutoutsCast = loaded.cutoutsCast;
    question.frustum = view.frustum;
    question.near = view.near();
    question.width = request.width;
    question.height = request.height;
    return question;
}

/// Adds the visible surfaces to the part, by area, material and node.
void addSurfaces(const LoadedScene& loaded, const lab::Oracle& oracle,
                 const std::vector<lab::PixelSurface>& surfaces, hours::Part& part) {
    hours::Exposure& exposure = part.exposure;
    exposure.material.assign(surfaces.size(), hours::Exposure::none);
    exposure.node.assign(surfaces.size(), hours::Exposure::none);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const bool known = exposure.surface[i] != 0 && surfaces[i].area > 0.0;
        exposure.area.push_back(known ? static_cast<float>(surfaces[i].area) : 0.0f);
        if (!known) continue;
        const rays::SurfaceTriangle& triangle = oracle.triangles()[surfaces[i].triangle];
        const Batch& batch = loaded.scene.batches[triangle.batch];
        if (batch.ground) continue;
        const bool isFill = triangle.material >= loaded.scene.whole().materials.size();
        const auto node = isFill ? fillNode
                                 : static_cast<std::uint32_t>(nodeOf(
                                       *triangle.geometry, batch.placedBy, triangle.firstIndex));
        exposure.material[i] = triangle.material;
        exposure.node[i] = node;
        if (!part.materials.contains(triangle.material))
            part.materials[triangle.material] =
                isFill ? "section" : materialTitle(*loaded.document, triangle.material);
        if (!part.nodes.contains(node))
            part.nodes[node] = isFill ? "section" : nodeTitle(*loaded.document, node);
    }
}

/// Counts the part's positions for each pixel, and measures the visible surfaces.
void expose(const SunHoursOptions& options, const SunHoursWay& way, const LoadedScene& loaded,
            const FrameRequest& request, const lab::Oracle& oracle,
            const std::vector<glm::dvec3>& directions, hours::Part& part, ProgressBar& bar) {
    const std::vector<lab::PixelSurface> surfaces = lab::pixelSurfaces(
        oracle, [&](double share) { bar.show(surfacesShare * share, "measuring surfaces"); });
    hours::Exposure& exposure = part.exposure;
    exposure.width = request.width;
    exposure.height = request.height;
    bar.show(surfacesShare, countingText(directions.size()));
    if (way.byRays) {
        exposure.lit = lab::litCounts(oracle, surfaces, directions, [&](double share) {
            bar.show(surfacesShare + countingShare * share, countingText(directions.size()));
        });
        for (const lab::PixelSurface& surface : surfaces)
            exposure.surface.push_back(surface.area > 0.0);
    } else {
        const LitCounts counts = countLit(options, loaded, request, directions, bar);
        exposure.lit = counts.lit;
        for (const std::uint16_t drawn : counts.surface)
            exposure.surface.push_back(drawn > 0);
    }
    addSurfaces(loaded, oracle, surfaces, part);
}

void sunHours(const SunHoursOptions& options) {
    const SunHoursWay way = wayOf(options);
    const hours::Schedule schedule = options.schedule();
    const std::vector<hours::Position> positions = hours::positionsOf(schedule);
    const LoadedScene loaded = options.loadForHours(schedule, positions, way.byRays);
    const FrameRequest request = requestOf(options, loaded.scene);

    hours::Part part;
    std::tie(part.number, part.of) =
        options.part.value_or(std::pair<std::size_t, std::size_t>(1, 1));
    part.settings = options.settingsJson(schedule, loaded.scene);
    part.settings["by"] = nameOf(way);
    part.settings["by-reason"] = way.why;
    part.camera = cameraJson(request.frustum);
    part.scene = hashOf(loaded.scene);
    part.warnings = loaded.scene.warnings.sentences();
    part.positionsOfRun = positions.size();
    part.positions = hours::ofPart(positions, part.number, part.of);
    part.offset = schedule.offset;

    ProgressBar bar;
    const std::vector<glm::dvec3> directions = directionsOf(part.positions);
    const lab::Oracle oracle(questionOf(loaded, request), lab::textureAlpha(loaded));
    expose(options, way, loaded, request, oracle, directions, part, bar);
    for (const hours::ProbePoint& probe : options.probes) {
        bar.show(surfacesShare + countingShare, "testing points");
        part.probes.push_back(
            {probe, lab::seenFrom(oracle, probe.point, probe.normal, directions)});
    }
    bar.show(1.0, "done");
    if (!options.part) return writeSunHours(part, options.input, options.files);
    writeFile(options.files.picture, std::string_view(hours::textOf(part)));
    printResult(options.files.picture + ": part " + std::to_string(part.number) + " of " +
                    std::to_string(part.of) + ", " + std::to_string(part.positions.size()) +
                    " of " + std::to_string(positions.size()) + " sun positions",
                "");
}

/// Throws Error(usage) for files that only --surfaces writes.
void requirePicture(const SunHoursFiles& files) {
    requireJsonReport(files);
    if (!files.more.empty()) throw Error(ExitStatus::usage, "OUT: several files need --surfaces.");
    for (const char* end : {".glb", ".csv", ".npy"})
        if (files.picture.ends_with(end))
            throw Error(ExitStatus::usage,
                        "OUT: '" + files.picture + "' needs --surfaces; a picture is a .png.");
}

} // namespace

void addSunHoursCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand(
        "sunhours",
        "Count the hours of sunlight on each visible surface, as a picture and a report");
    const auto options = std::make_shared<SunHoursOptions>();
    addSceneFile(*verb, *options)->required();
    verb->add_option_function<std::vector<std::string>>(
            "OUT",
            [options](const std::vector<std::string>& paths) {
                options->files.picture = paths.front();
                options->files.more.assign(paths.begin() + 1, paths.end());
            },
            "The picture, .png; with --surfaces one or more of .glb, .csv, .npy")
        ->required();
    addSunHoursOptions(*verb, *options);
    verb->callback([options] {
        options->readWeatherFile();
        if (options->surface.surfaces) return sunHoursOfSurfaces(*options);
        requirePicture(options->files);
        sunHours(*options);
    });
}

} // namespace edgeshade::cli
