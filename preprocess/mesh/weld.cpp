#include "preprocess/mesh/weld.hpp"

#include "preprocess/base/radix_sort.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace edgeshade {
namespace {

/// Triangles that a thread is worth starting for.
constexpr std::size_t trianglesOfThread = std::size_t{1} << 14;

constexpr std::uint32_t signBit = 0x80000000u;

/// A number that is ordered as the coordinate is; -0 is +0.
std::uint32_t orderOf(float coordinate) {
    const std::uint32_t bits = glm::floatBitsToUint(coordinate + 0.0f);
    return bits & signBit ? ~bits : bits | signBit;
}

float coordinateOf(std::uint32_t order) {
    return glm::uintBitsToFloat(order & signBit ? order & ~signBit : ~order);
}

/// Ordered as orderedBefore() does.
using KeyedPosition = Keyed<3>;

KeyedPosition keyed(const glm::vec3& position, std::uint32_t number) {
    return {{orderOf(position.x), orderOf(position.y), orderOf(position.z)}, number};
}

glm::vec3 positionOf(const KeyedPosition& keyed) {
    return {coordinateOf(keyed.key[0]), coordinateOf(keyed.key[1]), coordinateOf(keyed.key[2])};
}

/// A cell of the snapping grid.
struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        auto hash = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
        hash = (hash ^ static_cast<std::uint64_t>(cell.y)) * 0xC2B2AE3D27D4EB4Fu;
        hash = (hash ^ static_cast<std::uint64_t>(cell.z)) * 0x165667B19E3779F9u;
        return static_cast<std::size_t>(hash ^ hash >> 32);
    }
};

/// Which cell of the axis. So far out that floats lie farther apart than cells are wide, only equal
/// coordinates are close: each has a cell of its own there, so that no cell fills up.
std::int64_t cellOf(float coordinate, double size) {
    constexpr double farthest = 0x1p52;
    const double cell = std::floor(static_cast<double>(coordinate) / size);
    if (std::abs(cell) < farthest) return static_cast<std::int64_t>(cell);
    // Neighbours of other floats are not neighbours here.
    std::int32_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    return (std::int64_t{1} << 60) + std::int64_t{4} * bits;
}

Cell cellOf(const glm::vec3& position, double size) {
    return {cellOf(position.x, size), cellOf(position.y, size), cellOf(position.z, size)};
}

/// The positions of vertices that triangles use, vertex by vertex.
std::vector<KeyedPosition> usedPositions(std::span<const glm::vec3> positions,
                                         std::span<const std::uint32_t> indices, Threads threads) {
    std::vector<std::uint8_t> used(positions.size(), 0);
    for (const std::uint32_t index : indices)
        used[index] = 1;
    const std::vector<ItemRange> parts = partsOf(positions.size(), trianglesOfThread, threads);
    std::vector<std::size_t> firsts(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        firsts[part] = static_cast<std::size_t>(
            std::count(&used[range.first], &used[range.first] + range.size(), std::uint8_t{1}));
    });
    std::vector<KeyedPosition> keys(toFirsts(firsts));
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::size_t next = firsts[part];
        for (std::size_t v = range.first; v < range.end; ++v)
            if (used[v]) keys[next++] = keyed(positions[v], static_cast<std::uint32_t>(v));
    });
    return keys;
}

/// Distinct positions, in order, and for each vertex which one it is at.
struct Places {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> ofVertex;
};

/// `keys`: sorted.
Places placesOf(const std::vector<KeyedPosition>& keys, std::size_t vertexCount, Threads threads) {
    const auto isNew = [&](std::size_t i) { return i == 0 || keys[i].key != keys[i - 1].key; };
    const std::vector<ItemRange> parts = partsOf(keys.size(), trianglesOfThread, threads);
    std::vector<std::uint32_t> firsts(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::uint32_t count = 0;
        for (std::size_t i = range.first; i < range.end; ++i)
            count += isNew(i) ? 1 : 0;
        firsts[part] = count;
    });
    Places places;
    places.positions.resize(toFirsts(firsts));
    places.ofVertex.resize(vertexCount);
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::uint32_t next = firsts[part];
        for (std::size_t i = range.first; i < range.end; ++i) {
            if (isNew(i)) places.positions[next++] = positionOf(keys[i]);
            places.ofVertex[keys[i].number] = next - 1;
        }
    });
    return places;
}

WeldedMesh weldedAt(Places places, std::span<const std::uint32_t> indices, Threads threads) {
    WeldedMesh mesh;
    mesh.positions = std::move(places.positions);
    const std::size_t triangleCount = indices.size() / 3;
    mesh.triangles.resize(triangleCount);
    mesh.source.resize(triangleCount);
    const std::vector<ItemRange> parts = partsOf(triangleCount, trianglesOfThread, threads);
    std::vector<std::size_t> kept(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::size_t next = range.first;
        for (std::size_t t = range.first; t < range.end; ++t) {
            Triangle& triangle = mesh.triangles[next];
            for (std::size_t c = 0; c < 3; ++c)
                triangle[c] = places.ofVertex[indices[3 * t + c]];
            mesh.source[next] = static_cast<std::uint32_t>(t);
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
                triangle[2] != triangle[0])
                ++next;
        }
        kept[part] = next - range.first;
    });
    closeGaps(mesh.triangles, parts, kept);
    closeGaps(mesh.source, parts, kept);
    mesh.degenerate = triangleCount - mesh.triangles.size();
    return mesh;
}

} // namespace

WeldedMesh weld(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                Threads threads) {
    if (indices.empty()) return {};
    Places places;
    {
        std::vector<KeyedPosition> keys = usedPositions(positions, indices, threads);
        radixSort(keys, threads);
        places = placesOf(keys, positions.size(), threads);
    }
    return weldedAt(std::move(places), indices, threads);
}

WeldedMesh weldAlike(std::span<const glm::vec3> positions, std::span<const std::uint32_t> alike,
                     std::span<const std::uint32_t> indices, Threads threads) {
    if (indices.empty()) return {};
    constexpr std::uint32_t unused = 0xFFFFFFFFu;
    std::vector<std::uint32_t> distinctOf(positions.size(), unused); // numbered as they are met
    std::vector<KeyedPosition> keys;
    for (const std::uint32_t index : indices) {
        std::uint32_t& first = distinctOf[alike[index]];
        if (first == unused) {
            first = static_cast<std::uint32_t>(keys.size());
            keys.push_back(keyed(positions[index], first));
        }
        distinctOf[index] = first;
    }
    radixSort(keys, threads);
    std::vector<std::uint32_t> rank(keys.size());
    Places places;
    places.positions.reserve(keys.size());
    for (const KeyedPosition& key : keys) {
        rank[key.number] = static_cast<std::uint32_t>(places.positions.size());
        places.positions.push_back(positionOf(key));
    }
    for (std::uint32_t& of : distinctOf)
        if (of != unused) of = rank[of];
    places.ofVertex = std::move(distinctOf);
    return weldedAt(std::move(places), indices, threads);
}

void snapPositions(std::vector<glm::vec3>& positions, double tolerance) {
    std::vector<glm::vec3> kept; // in the order of the positions
    std::unordered_map<Cell, std::vector<std::size_t>, CellHash> keptByCell;
    for (glm::vec3& position : positions) {
        const Cell home = cellOf(position, tolerance);
        std::size_t first = kept.size();
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    const auto cell = keptByCell.find({home.x + dx, home.y + dy, home.z + dz});
                    if (cell == keptByCell.end()) continue;
                    for (const std::size_t k : cell->second)
                        if (k < first &&
                            glm::distance(glm::dvec3(kept[k]), glm::dvec3(position)) < tolerance)
                            first = k;
                }
        if (first < kept.size()) {
            position = kept[first];
        } else {
            keptByCell[home].push_back(kept.size());
            kept.push_back(position);
        }
    }
}

} // namespace edgeshade
