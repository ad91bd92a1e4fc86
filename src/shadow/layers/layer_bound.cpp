#include "src/shadow/layers/layer_bound.hpp"

#include "preprocess/mesh/topology.hpp"
#include "src/shadow/layers/crowded_directions.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace edgeshade {
namespace {

/// Units that each belong to one group: a triangle, or a whole place of a mesh stored once.
struct Units {
    std::vector<std::uint32_t> of; ///< by triangle, ascending
    std::size_t count = 0;

    void add(std::size_t triangles, bool together) {
        for (std::size_t t = 0; t < triangles; ++t)
            of.push_back(static_cast<std::uint32_t>(together ? count : count + t));
        count += together ? 1 : triangles;
    }
};

/// The number of a cell's members in each unit.
std::map<std::uint32_t, std::size_t> membersByUnit(const TriangleIndices& cell,
                                                   const Units& units) {
    std::map<std::uint32_t, std::size_t> members;
    for (const std::uint32_t triangle : cell)
        ++members[units.of[triangle]];
    return members;
}

/// A place whose triangles alone crowd a cell is divided into single triangles.
Units unitsOf(const Scene& scene, bool castMasked, const std::vector<TriangleIndices>& crowded,
              std::size_t limit) {
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    const std::vector<std::size_t> triangles = casterCounts(scene, castMasked);
    std::vector<std::size_t> places(first.size(), 0);
    Units whole;
    std::vector<std::uint32_t> unitOfBatch;
    for (std::size_t i = 0; i < first.size(); ++i)
        ++places[first[i]];
    for (std::size_t i = 0; i < first.size(); ++i) {
        unitOfBatch.push_back(static_cast<std::uint32_t>(whole.count));
        whole.add(triangles[i], places[first[i]] > 1);
    }
    std::vector<bool> tooMany(whole.count, false);
    for (const TriangleIndices& cell : crowded)
        for (const auto& [unit, count] : membersByUnit(cell, whole))
            if (count > limit) tooMany[unit] = true;
    if (std::find(tooMany.begin(), tooMany.end(), true) == tooMany.end()) return whole;
    Units units;
    for (std::size_t i = 0; i < first.size(); ++i)
        units.add(triangles[i],
                  places[first[i]] > 1 && triangles[i] > 0 && !tooMany[unitOfBatch[i]]);
    return units;
}

/// Assigns groups so that no crowded cell has more than `limit` members of one; units outside
/// crowded cells are in group 0. Gives up if it needs more than mostGroups.
void assignGroups(const std::vector<TriangleIndices>& crowded, const Units& units,
                  std::size_t limit, LayerBound& bound) {
    struct Share {
        std::uint32_t cell;
        std::size_t members;
    };
    std::vector<std::vector<Share>> sharesOf(units.count);
    for (std::uint32_t cell = 0; cell < crowded.size(); ++cell)
        for (const auto& [unit, members] : membersByUnit(crowded[cell], units))
            sharesOf[unit].push_back({cell, members});

    std::vector<std::uint32_t> groupOf(units.count, 0);
    std::vector<std::vector<std::size_t>> taken; // by group, by cell
    for (std::size_t unit = 0; unit < units.count; ++unit) {
        const std::vector<Share>& shares = sharesOf[unit];
        if (shares.empty()) continue;
        const auto fits = [&](const std::vector<std::size_t>& counts) {
            return std::all_of(shares.begin(), shares.end(), [&](const Share& share) {
                return counts[share.cell] + share.members <= limit;
            });
        };
        auto group = std::find_if(taken.begin(), taken.end(), fits);
        if (group == taken.end() && taken.size() == mostGroups) {
            bound.mayOverflow = true;
            return;
        }
        if (group == taken.end())
            group = taken.insert(taken.end(), std::vector<std::size_t>(crowded.size(), 0));
        for (const Share& share : shares)
            (*group)[share.cell] += share.members;
        groupOf[unit] = static_cast<std::uint32_t>(group - taken.begin());
    }
    bound.groupCount = std::max<std::size_t>(1, taken.size());
    bound.groupOf.reserve(units.of.size());
    for (const std::uint32_t unit : units.of)
        bound.groupOf.push_back(groupOf[unit]);
}

} // namespace

LayerBound boundByTriangles(const Scene& scene, bool castMasked, std::span<const Light> lights,
                            std::size_t limit) {
    LayerBound bound;
    bound.most = scene.triangleCount();
    if (bound.most <= limit) return bound;

    bound.most = 0;
    std::vector<TriangleIndices> crowded;
    for (const Light& light : lights) {
        CrowdedDirections of = crowdedDirections(scene, castMasked, light, limit);
        bound.most = std::max(bound.most, of.most);
        std::move(of.crowded.begin(), of.crowded.end(), std::back_inserter(crowded));
    }
    if (bound.most > limit)
        assignGroups(crowded, unitsOf(scene, castMasked, crowded, limit), limit, bound);
    return bound;
}

} // namespace edgeshade
