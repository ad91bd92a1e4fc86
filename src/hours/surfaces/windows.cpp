#include "src/hours/surfaces/windows.hpp"

#include "preprocess/base/disjoint_sets.hpp"
#include "preprocess/mesh/edges.hpp"
#include "src/hours/surfaces/cell_light.hpp"
#include "src/hours/surfaces/patch_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace edgeshade::hours {
namespace {

/// Share of the largest patch's area from which another counts as its other side.
constexpr double sameSize = 0.95;
/// Directions of the sky that the sides of a pane are compared by.
constexpr std::size_t skyDirections = 256;

/// Directions above the horizon, even in solid angle: a spiral by the golden angle.
std::vector<glm::dvec3> sky() {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<glm::dvec3> directions;
    for (std::size_t i = 0; i < skyDirections; ++i) {
        const double up = (static_cast<double>(i) + 0.5) / skyDirections;
        const double level = std::sqrt(1.0 - up * up), turn = golden * static_cast<double>(i);
        directions.emplace_back(level * std::cos(turn), up, level * std::sin(turn));
    }
    return directions;
}

/// Unites the chosen triangles of one batch, from number `first` on, that share an edge.
void uniteNeighbours(const Scene& scene, std::span<const WorldTriangle> triangles,
                     std::uint32_t first, DisjointSets& sets) {
    const Geometry& geometry = *scene.batches[triangles.front().batch].geometry;
    std::vector<std::uint32_t> indices;
    for (const WorldTriangle& triangle : triangles)
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            indices.push_back(geometry.indices[triangle.firstIndex + corner]);
    const WeldedMesh mesh = weld(geometry.positions, indices);
    const EdgeList edges = buildEdges(mesh);
    for (const Edge& edge : edges.edges) {
        const std::span<const Opposite> opposites = edges.oppositesOf(edge);
        for (std::size_t i = 0; i < opposites.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const std::uint32_t p = mesh.source[opposites[i].triangle],
                                    q = mesh.source[opposites[j].triangle];
                if (triangles[p].node == triangles[q].node &&
                    triangles[p].material == triangles[q].material)
                    sets.unite(first + p, first + q);
            }
    }
}

/// For each triangle the first one of its window.
std::vector<std::uint32_t> windowOf(const Scene& scene, std::span<const WorldTriangle> triangles) {
    DisjointSets sets(triangles.size());
    for (std::size_t first = 0, end = 0; first < triangles.size(); first = end) {
        while (end < triangles.size() && triangles[end].batch == triangles[first].batch)
            ++end;
        uniteNeighbours(scene, triangles.subspan(first, end - first),
                        static_cast<std::uint32_t>(first), sets);
    }
    std::vector<std::uint32_t> firsts(triangles.size(), SurfaceCells::none), windows;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        std::uint32_t& first = firsts[sets.find(t)];
        first = std::min(first, t);
        windows.push_back(first);
    }
    return windows;
}

double areaOf(const Patch& patch, std::span<const WorldTriangle> triangles) {
    double area = 0.0;
    for (const std::uint32_t t : patch.triangles)
        area += areaOf(triangles[t]);
    return area;
}

/// The patches that may be the outside of each window, windows in the order of the file: its
/// largest, and those of about that size.
std::vector<std::vector<Patch>> sidesOf(const Scene& scene, const std::vector<Patch>& patches,
                                        std::span<const WorldTriangle> triangles) {
    const std::vector<std::uint32_t> windows = windowOf(scene, triangles);
    std::map<std::uint32_t, std::vector<Patch>> byWindow;
    for (const Patch& patch : patches)
        byWindow[windows[patch.triangles.front()]].push_back(patch);
    std::vector<std::vector<Patch>> sides;
    for (auto& [window, some] : byWindow) {
        const auto area = [&](const Patch& patch) { return areaOf(patch, triangles); };
        const double largest = area(*std::ranges::max_element(some, {}, area));
        std::erase_if(some, [&](const Patch& patch) { return area(patch) < sameSize * largest; });
        sides.push_back(std::move(some));
    }
    return sides;
}

} // namespace

SurfaceCells windowsOf(const Scene& scene, const SurfaceChoice& choice,
                       const WindowSettings& settings, const SensorLight& light) {
    SurfaceCells cells;
    cells.offset = settings.offset;
    cells.triangles = worldTriangles(scene, choice);
    cells.patchOf.assign(cells.triangles.size(), SurfaceCells::none);
    const std::vector<Patch> patches = patchesOf(scene, cells.triangles, settings.flatness);
    for (std::uint32_t p = 0; p < patches.size(); ++p)
        for (const std::uint32_t t : patches[p].triangles)
            cells.patchOf[t] = p;

    // One cell for every side; then the sides that see most stay.
    const GridSettings whole{std::numeric_limits<double>::infinity(), settings.offset,
                             settings.rise};
    const std::vector<std::vector<Patch>> windows = sidesOf(scene, patches, cells.triangles);
    for (const std::vector<Patch>& sides : windows)
        for (const Patch& side : sides)
            addPatchCells(side, whole, cells);
    const rays::LitBits seen = light(sensorsOf(cells, 0, cells.cells.size()), sky());
    std::vector<Cell> chosen;
    std::size_t first = 0;
    for (const std::vector<Patch>& sides : windows) {
        std::size_t best = first;
        for (std::size_t i = first; i < first + sides.size(); ++i)
            if (seen.count(i) > seen.count(best)) best = i;
        chosen.push_back(cells.cells[best]);
        first += sides.size();
    }
    cells.cells = std::move(chosen);
    return cells;
}

} // namespace edgeshade::hours
