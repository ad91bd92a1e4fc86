#include "preprocess/packing/pack.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/mesh/caster_simplification.hpp"
#include "preprocess/packing/packed_file.hpp"
#include "preprocess/packing/parts_json.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/reading/variants.hpp"
#include "shaders_es2/record_layout.glsl"

#include <limits>

namespace edgeshade {

namespace {

nlohmann::ordered_json borderJson(const BorderCounts& counts) {
    return {{"borders", counts.borders},
            {"non_manifold_edges", counts.nonManifold},
            {"degenerate_triangles", counts.degenerate},
            {"quads", counts.quads}};
}

/// JSON of the weld choice; null if the tolerance was given.
nlohmann::ordered_json weldChoiceJson(const PackReport& report) {
    if (!report.weldChoice) return nullptr;
    const WeldChoice& choice = *report.weldChoice;
    return {{"tolerance", choice.tolerance},
            {"largest_share_of_diagonal", largestWeldShare},
            {"before", borderJson(choice.before)},
            {"after", borderJson(choice.after)}};
}

} // namespace

nlohmann::ordered_json toJson(const PackReport& report) {
    using Json = nlohmann::ordered_json;
    const MeshStatistics& casters = report.casters;
    const std::size_t largest = casters.largestOppositeCount();
    const auto multiplicity = static_cast<std::size_t>(report.maxMultiplicity);
    Json byCount = Json::object();
    for (const auto& [n, count] : casters.edgesByOppositeCount)
        byCount[std::to_string(n)] = count;
    const std::size_t oppositeVertexCapRuns = casters.triangles * VERTICES_PER_CAP_PAIR;
    return {
        {"diagonal", report.diagonal},
        {"triangles", report.triangles},
        {"single_sided_triangles", report.singleSidedTriangles},
        {"batches", report.batches},
        {"shared_meshes", report.sharedMeshes},
        {"shared_places", report.sharedPlaces},
        {"degenerate_triangles", casters.degenerateTriangles},
        {"casting_surface_triangles", report.castingSurfaceTriangles},
        {"casting_triangles", casters.triangles}, // casters, simplified or not, as all below
        {"edges", casters.edges},
        {"edges_by_opposite_count", byCount},
        {"largest_opposite_count", largest},
        {"components", casters.components},
        {"closed_oriented_triangles", casters.closedOrientedTriangles},
        {"flat_edges_dropped", report.planePairs.flatEdges},
        {"records", report.planePairs.records},
        {"record_multiplicity", multiplicity},
        // Bytes of sides and caps on the GPU, instanced, beside Equations 6.8 and 6.9.
        {"bytes",
         {{"sides", report.planePairs.sideBytes},
          {"caps", report.planePairs.capBytes},
          {"published_equation", 16 * (2 + largest) * casters.edges + 48 * casters.triangles},
          {"stored", report.storedBytes},
          {"file", report.fileBytes}}},
        {"vertex_runs",
         {{"sides", report.planePairs.sideRuns},
          {"caps", report.planePairs.capRuns},
          {"published", casters.edges * largest * VERTICES_PER_SIDE + oppositeVertexCapRuns}}},
        {"seconds",
         {{"read", report.readSeconds},
          {"weld_choice", report.build.weldChoice},
          {"simplify", report.build.simplify},
          {"weld", report.build.weld},
          {"edges", report.build.edges},
          {"records", report.build.records},
          {"pack", report.build.pack}}},
        {"settings",
         {{"weld-tolerance", report.settings.weldTolerance},
          {"cast-masked", report.settings.castMasked},
          {"caster-error", report.settings.casterError},
          {"flat-tolerance", report.settings.flatTolerance},
          {"instances", nameOf(report.settings.instances)}}},
        {"weld_choice", weldChoiceJson(report)},
        {"variants", report.variants},
        {"animations", partsJson(report.animations)},
        {"cameras", partsJson(report.cameras)},
        {"lights", partsJson(report.lights)},
        {"warnings", report.warnings},
    };
}

namespace {

void countGeometry(const Batch& batch, const BatchTopology& topology,
                   const std::vector<Material>& materials, const CasterSettings& settings,
                   MeshStatistics& statistics, PlanePairCosts& costs) {
    const auto count = [&](const CasterMesh& mesh, const EdgeList& edges,
                           const Components& components) {
        return planePairCosts(mesh, edges, components, materials, settings.flatTolerance,
                              batch.deforms());
    };
    const Components components = findComponents(topology.mesh.welded, topology.edges);
    statistics = meshStatistics(topology.mesh.welded, topology.edges, components);
    if (!batch.deforms()) {
        costs = count(topology.mesh, topology.edges, components);
        return;
    }
    const CasterMesh mesh = weldForRecords(batch, castersOf(batch, materials, settings.castMasked));
    const EdgeList edges = buildEdges(mesh.welded);
    costs = count(mesh, edges, findComponents(mesh.welded, edges));
}

/// Counts all batches: casters for every place, records once for all places of a mesh.
void countBatches(PackInput& input, const CasterSettings& settings) {
    PackReport& report = input.report;
    const auto& materials = input.scene.materials;
    const std::vector<std::size_t> first = firstOfGeometry(input.scene.batches);
    std::vector<PlanePairCosts> costs(first.size());
    std::vector<MeshStatistics> casters(first.size());
    std::vector<std::size_t> places(first.size(), 0);
    for (std::size_t i = 0; i < first.size(); ++i) {
        const BatchTopology& topology = *input.topology[i];
        const Batch& batch = input.scene.batches[i];
        for (const SurfaceGroup& group : batch.geometry->groups) {
            const Material& material = materials[group.material];
            if (material.casts(settings.castMasked))
                report.castingSurfaceTriangles += group.indexCount / 3;
            if (!material.doubleSided) report.singleSidedTriangles += group.indexCount / 3;
        }
        if (first[i] == i) {
            Stopwatch watch;
            countGeometry(batch, topology, materials, settings, casters[i], costs[i]);
            report.build.records += watch.lap();
            report.planePairs += costs[i];
        } else {
            report.planePairs += costs[first[i]].runsAlone();
        }
        report.casters += casters[first[i]];
        ++places[first[i]];
    }
    report.batches = first.size();
    for (const std::size_t count : places)
        if (count > 1) {
            ++report.sharedMeshes;
            report.sharedPlaces += count;
        }
}

} // namespace

PackInput readForPacking(const std::filesystem::path& path, const CasterSettings& settings,
                         const ReadingLimits& limits) {
    Stopwatch watch;
    GltfDocument document = readGltf(path, limits);
    const double readSeconds = watch.lap();
    PackInput input = readForPacking(std::move(document), settings, false);
    input.report.readSeconds += readSeconds;
    return input;
}

PackInput readForPacking(GltfDocument document, const CasterSettings& wanted, bool useStored) {
    Stopwatch watch;
    PackInput input;
    input.document = std::move(document);
    const CasterSettings settings = settingsFor(input.document, wanted, &input.report.weldChoice);
    input.report.build.weldChoice = watch.lap();
    input.scene = flattenScene(input.document, settings.weldTolerance, {}, settings.instances);
    PackReport& report = input.report;
    report.readSeconds = watch.lap();
    const auto header = readShadowHeader(input.document);
    if (useStored && settings.casterError > 0.0 && header && header->settings == settings)
        readCasters(input.document, *header, input.scene);
    else
        simplifyCasters(input.scene, settings.casterError);
    report.build.simplify = watch.lap();
    input.topology = buildTopology(input.scene, settings.castMasked, report.build);

    report.settings = settings;
    report.diagonal = worldBounds(input.scene).diagonal();
    report.triangles = input.scene.triangleCount();
    countBatches(input, settings);
    report.maxMultiplicity = sceneMultiplicity(input.topology);
    report.storedBytes = storedShadowBytes(input.document);
    std::error_code error;
    const auto fileBytes = std::filesystem::file_size(input.document.path, error);
    report.fileBytes = error ? 0 : static_cast<std::size_t>(fileBytes); // a pipe has no size
    report.variants = variantNames(input.document);
    report.animations = playedAnimations(input.document, input.scene.warnings);
    report.cameras = input.scene.cameras;
    report.lights = input.scene.lights;
    report.warnings = input.scene.warnings.sentences();
    return input;
}

Bytes packBytes(PackInput& input, Encoding encoding) {
    Stopwatch watch;
    Bytes bytes = packedGlb(input.document, input.scene, input.topology, encoding,
                            input.report.settings, input.scene.warnings);
    ReadingLimits none = input.document.memory.limits(); // without the memory limit, as these bytes
                                                         // were made here
    none.memoryBytes = std::numeric_limits<std::uint64_t>::max();
    const GltfDocument packed = parseGltf(bytes, input.document.path, none);
    input.report.storedBytes = storedShadowBytes(packed);
    input.report.fileBytes = bytes.size();
    input.report.warnings = input.scene.warnings.sentences();
    input.report.build.pack = watch.lap();
    return bytes;
}

} // namespace edgeshade
