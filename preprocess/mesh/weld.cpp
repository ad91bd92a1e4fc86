#include "preprocess/mesh/weld.hpp"

#include "preprocess/base/radix_sort.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace edgeshade {
namespace {

/// Positions or triangles below which another thread isn't worth starting.
constexpr std::size_t itemsOfThread = std::size_t{1} << 14;

constexpr std::uint32_t signBit = 0x80000000u;

/// A key with the coordinate's order; -0 is +0.
std::uint32_t orderOf(float coordinate) {
    const std::uint32_t bits = glm::floatBitsToUint(coordinate + 0.0f);
    return bits & signBit ? ~bits : bits | signBit;
}

float coordinateOf(std::uint32_t order) {
    return glm::uintBitsToFloat(order & signBit ? order & ~signBit : ~order);
}

/// Sorts in the order of orderedBefore().
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

struct PositionHash {
    std::size_t operator()(const glm::vec3& position) const {
        return CellHash()({orderOf(position.x), orderOf(position.y), orderOf(position.z)});
    }
};

/// Cells of the snapping grid along one axis, each twice as wide as the tolerance: those that can
/// hold positions near a coordinate, its own included.
struct AxisCells {
    std::int64_t own, first, last;

    AxisCells(float coordinate, double tolerance) {
        constexpr double farthest = 0x1p52, wider = 1.001;
        const double size = 2.0 * tolerance, reach = wider * tolerance;
        const double cell = std::floor(static_cast<double>(coordinate) / size);
        if (std::abs(cell) < farthest) {
            own = static_cast<std::int64_t>(cell);
            first = static_cast<std::int64_t>(
                std::floor((static_cast<double>(coordinate) - reach) / size));
            last = static_cast<std::int64_t>(
                std::floor((static_cast<double>(coordinate) + reach) / size));
            return;
        }
        // At this distance floats are farther apart than cells are wide, and only equal coordinates
        // are near. Each gets its own cell, so that no cell fills up.
        std::int32_t bits = 0;
        std::memcpy(&bits, &coordinate, sizeof bits);
        own = first = last = (std::int64_t{1} << 60) + bits;
    }
};

/// Kept positions, by cell.
class KeptPositions {
  public:
    explicit KeptPositions(double tolerance) : tolerance_(tolerance) {}

    /// The first kept position nearer than the tolerance; otherwise this one, which is kept.
    glm::vec3 snapped(const glm::vec3& position) {
        const AxisCells x(position.x, tolerance_), y(position.y, tolerance_),
            z(position.z, tolerance_);
        std::uint32_t first = none;
        for (std::int64_t i = x.first; i <= x.last; ++i)
            for (std::int64_t j = y.first; j <= y.last; ++j)
                for (std::int64_t k = z.first; k <= z.last; ++k)
                    first = std::min(first, firstIn({i, j, k}, position));
        if (first != none) return kept_[first].position;
        std::uint32_t& newest = newestIn_.try_emplace({x.own, y.own, z.own}, none).first->second;
        kept_.push_back({position, newest});
        newest = static_cast<std::uint32_t>(kept_.size() - 1);
        return position;
    }

  private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;
    struct Kept {
        glm::vec3 position;
        std::uint32_t before; ///< the previous one in its cell
    };

    std::uint32_t firstIn(const Cell& cell, const glm::vec3& position) const {
        const auto found = newestIn_.find(cell);
        std::uint32_t first = none;
        for (std::uint32_t k = found == newestIn_.end() ? none : found->second; k != none;
             k = kept_[k].before)
            if (glm::distance(glm::dvec3(kept_[k].position), glm::dvec3(position)) < tolerance_)
                first = k; // the list runs from newest to oldest
        return first;
    }

    const double tolerance_;
    std::vector<Kept> kept_;
    std::unordered_map<Cell, std::uint32_t, CellHash> newestIn_;
};

/// Positions of the vertices that triangles use, in vertex order.
std::vector<KeyedPosition> usedPositions(std::span<const glm::vec3> positions,
                                         std::span<const std::uint32_t> indices, Threads threads) {
    std::vector<std::uint8_t> used(positions.size(), 0);
    for (const std::uint32_t index : indices)
        used[index] = 1;
    const std::vector<ItemRange> parts = partsOf(positions.size(), itemsOfThread, threads);
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

/// Distinct positions, sorted, and the index of each vertex's position.
struct Places {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> ofVertex;
};

/// `keys` must be sorted.
Places placesOf(const std::vector<KeyedPosition>& keys, std::size_t vertexCount, Threads threads) {
    const auto isNew = [&](std::size_t i) { return i == 0 || keys[i].key != keys[i - 1].key; };
    const std::vector<ItemRange> parts = partsOf(keys.size(), itemsOfThread, threads);
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
    const std::vector<ItemRange> parts = partsOf(triangleCount, itemsOfThread, threads);
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
    // numbered in order of first use
    std::vector<std::uint32_t> distinctOf(positions.size(), unused);
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
    KeptPositions kept(tolerance);
    // equal positions go to the same place
    std::unordered_map<glm::vec3, glm::vec3, PositionHash> known;
    for (glm::vec3& position : positions) {
        const auto [place, isNew] = known.try_emplace(position);
        if (isNew) place->second = kept.snapped(position);
        position = place->second;
    }
}

} // namespace edgeshade
