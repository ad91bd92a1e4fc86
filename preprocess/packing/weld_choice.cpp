#include "preprocess/packing/weld_choice.hpp"

#include "preprocess/mesh/components.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/volumes/clustering.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Number of tolerances tried: each is a quarter of the one before, the last 1e-7 of the diagonal.
constexpr int tried = 6;
constexpr double step = 0.25;
/// Share of the best gain that is enough.
constexpr double nearly = 0.95;

void count(const CasterMesh& mesh, const std::vector<Material>& materials, std::size_t places,
           BorderCounts& counts) {
    const EdgeList edges = buildEdges(mesh.welded);
    const Components components = findComponents(mesh.welded, edges);
    const std::vector<std::uint8_t> closed = countsHalf(mesh, components, materials);
    counts.degenerate += places * mesh.welded.degenerate;
    for (const Edge& edge : edges.edges) {
        const std::uint32_t n = edge.oppositeCount;
        const std::uint32_t triangle = edges.opposites[edge.firstOpposite].triangle;
        const bool half = closed[components.ofTriangle[triangle]] != 0;
        counts.borders += n == 1 ? places : 0;
        counts.nonManifold += n > 2 ? places : 0;
        counts.quads += places * (half ? n / 2 : n);
    }
}

BorderCounts countsOf(const Scene& scene, bool castMasked) {
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    BorderCounts counts;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Batch& batch = scene.batches[i];
        if (first[i] != i || batch.deforms()) continue; // deforming batches aren't welded
        const auto places = static_cast<std::size_t>(std::count(first.begin(), first.end(), i));
        count(weldCasters(batch, castingSurfacesOf(*batch.geometry, scene.materials, castMasked)),
              scene.materials, places, counts);
    }
    return counts;
}

/// Borders closed, minus the harm done; below 0 if the harm is larger.
double gainOf(const BorderCounts& before, const BorderCounts& after) {
    return static_cast<double>(WeldChoice::closed(before, after)) -
           static_cast<double>(WeldChoice::harm(before, after));
}

} // namespace

std::size_t WeldChoice::closed(const BorderCounts& before, const BorderCounts& after) {
    const std::size_t lost =
        after.borders + 3 * (std::max(after.degenerate, before.degenerate) - before.degenerate);
    return std::max(before.borders, lost) - lost;
}

std::size_t WeldChoice::harm(const BorderCounts& before, const BorderCounts& after) {
    return std::max(after.degenerate, before.degenerate) - before.degenerate +
           std::max(after.nonManifold, before.nonManifold) - before.nonManifold;
}

WeldChoice chooseWeldTolerance(const GltfDocument& document, const CasterSettings& settings) {
    WeldChoice choice;
    double tolerance = 0.0;
    {
        const Scene scene = flattenScene(document, 0.0, {}, settings.instances);
        tolerance = largestWeldShare * worldBounds(scene).diagonal();
        choice.before = choice.after = countsOf(scene, settings.castMasked);
    }
    double best = 0.0;
    for (int i = 0; i < tried && tolerance > 0.0 && choice.before.borders > 0; ++i) {
        const BorderCounts counts = countsOf(
            flattenScene(document, tolerance, {}, settings.instances), settings.castMasked);
        const double gain = gainOf(choice.before, counts);
        best = std::max(best, gain);
        if (gain > 0.0 && gain >= nearly * best) {
            choice.tolerance = tolerance;
            choice.after = counts;
        }
        tolerance *= step;
    }
    return choice;
}

CasterSettings settingsFor(const GltfDocument& document, CasterSettings settings,
                           std::optional<WeldChoice>* choice) {
    if (!settings.autoWeld) return settings;
    const WeldChoice chosen = chooseWeldTolerance(document, settings);
    settings.weldTolerance = chosen.tolerance;
    settings.autoWeld = false;
    if (choice) *choice = chosen;
    return settings;
}

} // namespace edgeshade
