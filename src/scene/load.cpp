#include "src/scene/load.hpp"

#include "preprocess/base/names.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/mesh/caster_simplification.hpp"
#include "preprocess/packing/shadow_extension.hpp"
#include "preprocess/packing/weld_choice.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/image/image_choice.hpp"
#include "src/shadow/lights/light.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

const char* nameOf(LoadStage stage) {
    using enum LoadStage;
    return nameIn({{read, "read"}, {flatten, "flatten"}, {images, "images"}, {shadows, "shadows"}},
                  stage);
}

LoadedScene readScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted, const ReadingLimits& limits,
                      const std::function<void(LoadStage)>& onStage, const Looks& looks) {
    if (onStage) onStage(LoadStage::read);
    LoadedScene loaded;
    loaded.document = std::make_shared<const GltfDocument>(readGltf(path, limits));
    loaded.looks = looks;
    const auto header = readShadowHeader(*loaded.document);
    loaded.settings = settingsFor(*loaded.document,
                                  wanted.value_or(header ? header->settings : CasterSettings()));
    if (onStage) onStage(LoadStage::flatten);
    loaded.scene = flattenScene(*loaded.document, loaded.settings.weldTolerance, looks,
                                loaded.settings.instances);
    loaded.scene.culls = cullsByDefault;
    if (const std::size_t lights = loaded.scene.lights.size(); lights > mostLights)
        loaded.scene.warnings.add("'" + path.string() + "' has " + std::to_string(lights) +
                                  " lights, but a picture has at most " +
                                  std::to_string(mostLights) + "; the others are left out.");
    return loaded;
}

void addShadows(LoadedScene& loaded) {
    const auto header = readShadowHeader(*loaded.document);
    const bool fits = header && header->settings == loaded.settings;
    if (fits && loaded.looks.variant.empty()) {
        readCasters(*loaded.document, *header, loaded.scene);
        if (header->encoding != Encoding::none)
            loaded.shadows = readShadows(*loaded.document, *header, loaded.scene);
    } else {
        simplifyCasters(loaded.scene, loaded.settings.casterError);
        if (header && !fits)
            loaded.scene.warnings.add("The file was packed with other caster settings; its shadow "
                                      "data are rebuilt.");
    }
    loaded.planePairs =
        buildPlanePairs(loaded.scene, loaded.settings.castMasked, loaded.settings.flatTolerance);
}

LoadedScene loadScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted, const ReadingLimits& limits,
                      const std::function<void(LoadStage)>& onStage, const Looks& looks) {
    LoadedScene loaded = readScene(path, wanted, limits, onStage, looks);
    if (onStage) onStage(LoadStage::images);
    loaded.images = decodeImages(*loaded.document, loaded.scene);
    if (onStage) onStage(LoadStage::shadows);
    addShadows(loaded);
    return loaded;
}

LoadedScene loadSurfaces(const std::filesystem::path& path,
                         const std::optional<CasterSettings>& wanted, const ReadingLimits& limits,
                         const Looks& looks) {
    LoadedScene loaded = readScene(path, wanted, limits, {}, looks);
    loaded.images = decodeImages(*loaded.document, loaded.scene);
    loaded.planePairs.assign(loaded.scene.batches.size(),
                             std::make_shared<const PlanePairShadow>());
    return loaded;
}

void addGround(LoadedScene& loaded, const Ground& ground) {
    if (!addGround(loaded.scene, ground)) return;
    loaded.ground = ground;
    // The ground casts nothing.
    loaded.planePairs.push_back(std::make_shared<const PlanePairShadow>());
    if (!loaded.shadows.empty()) loaded.shadows.push_back(std::make_shared<const BatchShadow>());
}

std::shared_ptr<const Image> pixelsOf(const LoadedScene& loaded, int image) {
    const auto found = loaded.images.find(image);
    if (found != loaded.images.end()) return found->second;
    MemoryBudget memory = loaded.document->memory;
    return std::make_shared<const Image>(decodeImage(*loaded.document, image, memory));
}

namespace {

/// (u, v, alpha of the vertex colour, 0) of a corner of a welded triangle.
glm::vec4 alphaCornerAt(const Batch& batch, const Casters& casters, const CasterMesh& mesh,
                        std::size_t triangle, std::size_t corner) {
    const std::uint32_t vertex = casters.indices[3 * mesh.welded.source[triangle] + corner];
    const Geometry& geometry = *batch.geometry;
    // Rounded like the surfaces' colours. A host's mesh that tests no alpha has neither.
    const float alpha =
        geometry.colors.empty() ? 1.0f : std::round(geometry.colors[vertex].a * 255.0f) / 255.0f;
    return {geometry.texcoords.empty() ? glm::vec2(0.0f) : geometry.texcoords[vertex], alpha, 0.0f};
}

} // namespace

std::vector<glm::vec4> alphaCorners(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh) {
    std::vector<glm::vec4> alphas;
    alphas.reserve(3 * mesh.welded.triangles.size());
    for (std::size_t t = 0; t < mesh.welded.triangles.size(); ++t) {
        const Triangle& triangle = mesh.welded.triangles[t];
        std::array<std::size_t, 3> corners = {0, 1, 2};
        std::sort(corners.begin(), corners.end(),
                  [&](std::size_t a, std::size_t b) { return triangle[a] < triangle[b]; });
        for (const std::size_t corner : corners)
            alphas.push_back(alphaCornerAt(batch, casters, mesh, t, corner));
    }
    return alphas;
}

std::vector<glm::vec4> alphaCorners(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh, const PlanePairShadow& shadow) {
    std::vector<glm::vec4> alphas;
    const bool needed =
        std::any_of(shadow.clusters.begin(), shadow.clusters.end(),
                    [](const ShadowCluster& cluster) { return cluster.alphaTested; });
    if (!needed) return alphas;
    alphas.reserve(3 * shadow.capTriangles.size());
    for (const std::uint32_t triangle : shadow.capTriangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            alphas.push_back(alphaCornerAt(batch, casters, mesh, triangle, corner));
    return alphas;
}

} // namespace edgeshade
