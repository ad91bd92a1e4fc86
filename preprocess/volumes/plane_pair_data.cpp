#include "preprocess/volumes/plane_pair_data.hpp"

#include "preprocess/base/prefetch.hpp"
#include "preprocess/volumes/cap_boxes.hpp"
#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/opposite_pairs.hpp"
#include "preprocess/volumes/side_writer.hpp"
#include "preprocess/volumes/triangle_planes.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace edgeshade {
namespace {

/// Writes the caps, in the order of clusters; returns the cap of each triangle.
std::vector<std::uint32_t> addCaps(const WeldedMesh& mesh, const std::vector<glm::vec4>& planes,
                                   Threads threads, PlanePairShadow& shadow) {
    const std::vector<std::uint32_t>& triangles = shadow.capTriangles;
    shadow.caps.resize(triangles.size());
    std::vector<std::uint32_t> capOf(triangles.size());
    forEachItem(triangles.size(), itemsOfThread, threads, [&](std::size_t i) {
        constexpr std::size_t ahead = 8;
        if (i + 2 * ahead < triangles.size()) {
            prefetch(mesh.triangles[triangles[i + 2 * ahead]]);
            prefetch(planes[triangles[i + 2 * ahead]]);
            for (const std::uint32_t corner : mesh.triangles[triangles[i + ahead]])
                prefetch(mesh.positions[corner]);
        }
        const std::uint32_t triangle = triangles[i];
        const Triangle& corners = mesh.triangles[triangle];
        capOf[triangle] = static_cast<std::uint32_t>(i);
        shadow.caps[i] = {mesh.positions[corners[0]], mesh.positions[corners[1]],
                          mesh.positions[corners[2]], planes[triangle]};
    });
    return capOf;
}

/// Numbers of pairs and of singles.
struct SideCounts {
    std::size_t pairs = 0, singles = 0;
};

/// The most records that the edges can have, reached if no pair is flat.
SideCounts mostSides(const EdgeList& edges, const std::vector<std::uint32_t>& order,
                     const ItemRange& range) {
    SideCounts counts;
    for (std::size_t i = range.first; i < range.end; ++i) {
        if (i + 16 < range.end) prefetch(edges.edges[order[i + 16]]);
        const std::uint32_t n = edges.edges[order[i]].oppositeCount;
        counts.pairs += n / 2;
        counts.singles += n % 2;
    }
    return counts;
}

/// Writes pairs and singles; returns their numbers for each cluster.
std::vector<SideCounts> addSides(const WeldedMesh& mesh, const EdgeList& edges,
                                 const std::vector<glm::vec4>& planes,
                                 const std::vector<std::uint32_t>& capOf,
                                 const TriangleClusters& clustered, Threads threads,
                                 PlanePairShadow& shadow, RecordVertices* vertices) {
    const auto parts = partsOf(clustered.edges.size(), itemsOfThread, threads);
    std::vector<ItemRange> pairsOf(parts.size()), singlesOf(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        const SideCounts most = mostSides(edges, clustered.edges, range);
        pairsOf[part].end = most.pairs;
        singlesOf[part].end = most.singles;
    });
    for (std::size_t part = 1; part < parts.size(); ++part)
        for (auto* ranges : {&pairsOf, &singlesOf})
            (*ranges)[part] = {(*ranges)[part - 1].end,
                               (*ranges)[part - 1].end + (*ranges)[part].end};
    shadow.pairs.resize(pairsOf.back().end);
    shadow.pairPlanes.resize(pairsOf.back().end);
    shadow.singles.resize(singlesOf.back().end);
    shadow.singlePlanes.resize(singlesOf.back().end);
    if (vertices) {
        vertices->pairs.resize(pairsOf.back().end);
        vertices->singles.resize(singlesOf.back().end);
    }

    std::vector<std::size_t> pairCounts(parts.size()), flatPairs(parts.size()),
        flatEdges(parts.size());
    std::vector<std::vector<SideCounts>> counts(parts.size());
    const auto clusterOf = [&](std::size_t edge) { // by index of the ordered edges
        const auto after = std::upper_bound(
            clustered.clusters.begin(), clustered.clusters.end(), edge,
            [](std::size_t e, const TriangleCluster& cluster) { return e < cluster.edges.end; });
        return static_cast<std::size_t>(after - clustered.clusters.begin());
    };
    const auto edgeAt = [&](std::size_t i) -> const Edge& {
        return edges.edges[clustered.edges[i]];
    };
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        SideWriter writer(mesh.positions, edges, planes, capOf);
        writer.pair = pairsOf[part].first;
        writer.single = singlesOf[part].first;
        std::size_t cluster = clusterOf(range.first);
        for (std::size_t i = range.first; i < range.end; ++cluster) {
            const std::size_t end = std::min(range.end, clustered.clusters[cluster].edges.end);
            const std::size_t pair = writer.pair, single = writer.single;
            for (; i < end; ++i) {
                constexpr std::size_t ahead = 8;
                if (i + 3 * ahead < range.end) {
                    prefetch(edgeAt(i + 3 * ahead));
                    writer.prefetchEdge(edgeAt(i + 2 * ahead));
                    writer.prefetchTriangles(edgeAt(i + ahead));
                }
                writer.write(edgeAt(i), shadow, vertices);
            }
            counts[part].push_back({writer.pair - pair, writer.single - single});
        }
        pairCounts[part] = writer.pair - pairsOf[part].first;
        flatPairs[part] = writer.flatPairs;
        flatEdges[part] = writer.flatEdges;
    });
    closeGaps(shadow.pairs, pairsOf, pairCounts);
    closeGaps(shadow.pairPlanes, pairsOf, pairCounts);

    std::vector<SideCounts> byCluster(clustered.clusters.size());
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const std::size_t first = clusterOf(parts[part].first);
        for (std::size_t i = 0; i < counts[part].size(); ++i) {
            byCluster[first + i].pairs += counts[part][i].pairs;
            byCluster[first + i].singles += counts[part][i].singles;
        }
        shadow.flatPairs += flatPairs[part];
        shadow.flatEdges += flatEdges[part];
    }
    shadow.edges = clustered.edges.size();
    return byCluster;
}

RecordRange rangeAfter(const RecordRange& last, std::size_t count) {
    return {last.end(), static_cast<std::uint32_t>(count)};
}

/// Groups a cluster's caps by material, where the material matters.
void addGroups(const CasterMesh& mesh, const TriangleCluster& cluster,
               std::span<const std::uint32_t> triangles, std::vector<MaterialCasters>& groups) {
    auto firstCap = static_cast<std::uint32_t>(cluster.triangles.first);
    if (!cluster.alphaTested) {
        const std::size_t anyMaterial = mesh.groups.front().material; // all are opaque
        groups.push_back({anyMaterial, firstCap, static_cast<std::uint32_t>(triangles.size())});
        return;
    }
    const std::size_t firstGroup = groups.size();
    for (const std::uint32_t triangle : triangles) {
        const auto after = std::upper_bound(
            mesh.groups.begin(), mesh.groups.end(), triangle,
            [](std::uint32_t t, const MaterialCasters& group) { return t < group.firstCap; });
        const std::size_t material = std::prev(after)->material;
        if (groups.size() == firstGroup || groups.back().material != material)
            groups.push_back({material, firstCap, 0});
        ++groups.back().capCount;
        ++firstCap;
    }
}

/// Adds the clusters; `sides`: their numbers of records.
void addClusters(const CasterMesh& mesh, const TriangleClusters& clustered,
                 const std::vector<SideCounts>& sides, PlanePairShadow& shadow) {
    ShadowCluster last;
    for (std::size_t i = 0; i < clustered.clusters.size(); ++i) {
        const TriangleCluster& cluster = clustered.clusters[i];
        const std::size_t caps = cluster.triangles.size(), groups = shadow.groups.size();
        addGroups(mesh, cluster,
                  std::span(shadow.capTriangles).subspan(cluster.triangles.first, caps),
                  shadow.groups);
        last = {cluster.bounds,
                cluster.closed,
                cluster.alphaTested,
                cluster.components,
                rangeAfter(last.pairs, sides[i].pairs),
                rangeAfter(last.singles, sides[i].singles),
                rangeAfter(last.caps, caps),
                cluster.singleSided,
                rangeAfter(last.groups, shadow.groups.size() - groups),
                rangeAfter(last.leaves, (caps + leafTriangles - 1) / leafTriangles)};
        shadow.clusters.push_back(last);
    }
}

PlanePairShadow recordsOf(const CasterMesh& mesh, const EdgeList& edges,
                          const std::vector<Material>& materials,
                          const std::vector<glm::vec4>& planes, RecordVertices* vertices,
                          Threads threads) {
    TriangleClusters clustered = clusterTrianglesOf(mesh, edges, materials, threads);
    PlanePairShadow shadow;
    shadow.capTriangles = std::move(clustered.triangles);
    const std::vector<std::uint32_t> capOf = addCaps(mesh.welded, planes, threads, shadow);
    if (vertices)
        for (const std::uint32_t triangle : shadow.capTriangles)
            vertices->caps.push_back(mesh.welded.triangles[triangle]);
    const std::vector<SideCounts> sides =
        addSides(mesh.welded, edges, planes, capOf, clustered, threads, shadow, vertices);
    addClusters(mesh, clustered, sides, shadow);
    addLeaves(threads, shadow);
    return shadow;
}

/// One vertex of the batch for each welded vertex.
std::vector<std::uint32_t> batchVertices(const CasterMesh& mesh, const Casters& casters) {
    std::vector<std::uint32_t> inBatch(mesh.welded.positions.size());
    for (std::size_t t = 0; t < mesh.welded.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            inBatch[mesh.welded.triangles[t][c]] = casters.indices[3 * mesh.welded.source[t] + c];
    return inBatch;
}

/// Moves records to the vertices' positions; each keeps the triangles whose planes it holds.
class Poser {
  public:
    Poser(const RecordVertices& vertices, const Batch& batch) : vertices_(vertices) {
        points_.reserve(vertices.inBatch.size());
        for (const std::uint32_t vertex : vertices.inBatch)
            points_.push_back(batch.geometry->positions[vertex]);
    }

    CapRecord cap(std::size_t i) const {
        const auto& [a, b, c] = vertices_.caps[i];
        return {points_[a], points_[b], points_[c],
                trianglePlane(points_[a], points_[b], points_[c])};
    }
    PairRecord pair(std::size_t i, const std::array<PlaneOf, 2>& planes,
                    const std::vector<CapRecord>& caps) const {
        const auto& [a, b] = vertices_.pairs[i];
        return {points_[a], points_[b], planeIn(caps, planes[0]), planeIn(caps, planes[1])};
    }
    SingleRecord single(std::size_t i, PlaneOf plane, const std::vector<CapRecord>& caps) const {
        const auto& [a, b] = vertices_.singles[i];
        return {points_[a], points_[b], planeIn(caps, plane)};
    }

  private:
    static glm::vec4 planeIn(const std::vector<CapRecord>& caps, PlaneOf of) {
        const glm::vec4& plane = caps[of.cap()].plane;
        return of.negated() ? -plane : plane;
    }

    const RecordVertices& vertices_;
    std::vector<glm::vec3> points_; ///< welded
};

} // namespace

PlanePairShadow buildPlanePairs(const CasterMesh& mesh, const EdgeList& edges,
                                const std::vector<Material>& materials, double flatTolerance,
                                Threads threads) {
    return recordsOf(mesh, edges, materials,
                     trianglePlanes(mesh.welded, edges, flatTolerance, threads), nullptr, threads);
}

PlanePairShadow buildPlanePairs(const Batch& batch, const Casters& casters,
                                const std::vector<Material>& materials, double flatTolerance) {
    const CasterMesh mesh = weldForRecords(batch, casters);
    const EdgeList edges = buildEdges(mesh.welded);
    if (!batch.deforms()) return buildPlanePairs(mesh, edges, materials, flatTolerance);
    std::vector<glm::vec4> planes;
    planes.reserve(mesh.welded.triangles.size());
    for (const Triangle& triangle : mesh.welded.triangles)
        planes.push_back(trianglePlane(mesh.welded.positions[triangle[0]],
                                       mesh.welded.positions[triangle[1]],
                                       mesh.welded.positions[triangle[2]]));
    RecordVertices vertices;
    vertices.inBatch = batchVertices(mesh, casters);
    PlanePairShadow shadow = recordsOf(mesh, edges, materials, planes, &vertices, {});
    shadow.vertices = std::make_shared<const RecordVertices>(std::move(vertices));
    return shadow;
}

WeldedMesh weldCaps(std::span<const CapRecord> caps) {
    std::vector<glm::vec3> corners;
    corners.reserve(3 * caps.size());
    for (const CapRecord& cap : caps)
        corners.insert(corners.end(), {cap.a, cap.b, cap.c});
    std::vector<std::uint32_t> indices(corners.size());
    std::iota(indices.begin(), indices.end(), 0u);
    return weld(corners, indices);
}

PlanePairShadow posedPlanePairs(const PlanePairShadow& shadow, const Batch& batch) {
    PlanePairShadow posed = shadow;
    const Poser poser(*shadow.vertices, batch);
    for (std::size_t i = 0; i < posed.caps.size(); ++i)
        posed.caps[i] = poser.cap(i);
    for (std::size_t i = 0; i < posed.pairs.size(); ++i)
        posed.pairs[i] = poser.pair(i, posed.pairPlanes[i], posed.caps);
    for (std::size_t i = 0; i < posed.singles.size(); ++i)
        posed.singles[i] = poser.single(i, posed.singlePlanes[i], posed.caps);
    for (ShadowCluster& cluster : posed.clusters) {
        cluster.bounds = boxOf(posed.caps, cluster.caps.first, cluster.caps.end());
        for (std::uint32_t i = 0; i < cluster.leaves.count; ++i) {
            const std::uint32_t first = cluster.caps.first + i * leafTriangles;
            posed.leaves[cluster.leaves.first + i] =
                boxOf(posed.caps, first, std::min(first + leafTriangles, cluster.caps.end()));
        }
    }
    return posed;
}

PlanePairCosts& PlanePairCosts::operator+=(const PlanePairCosts& other) {
    records += other.records;
    flatEdges += other.flatEdges;
    sideBytes += other.sideBytes;
    capBytes += other.capBytes;
    sideRuns += other.sideRuns;
    capRuns += other.capRuns;
    return *this;
}

PlanePairCosts PlanePairCosts::runsAlone() const {
    PlanePairCosts costs;
    costs.sideRuns = sideRuns;
    costs.capRuns = capRuns;
    return costs;
}

namespace {

constexpr std::size_t quadVertices = 4, capPairVertices = 6;

std::size_t sideRunsOf(const SideCounts& sides, bool closed) {
    return quadVertices * ((closed ? 1 : 2) * sides.pairs + sides.singles);
}

/// All costs without runs of sides.
PlanePairCosts costsOf(const SideCounts& sides, std::size_t flatEdges, std::size_t caps) {
    PlanePairCosts costs;
    costs.records = sides.pairs + sides.singles;
    costs.flatEdges = flatEdges;
    costs.sideBytes = sides.pairs * sizeof(PairRecord) + sides.singles * sizeof(SingleRecord);
    costs.capBytes = caps * sizeof(CapRecord);
    costs.capRuns = capPairVertices * caps;
    return costs;
}

} // namespace

PlanePairCosts planePairCosts(const CasterMesh& mesh, const EdgeList& edges,
                              const Components& components, const std::vector<Material>& materials,
                              double flatTolerance, bool deforms, Threads threads) {
    const std::vector<std::uint8_t> closed = countsHalf(mesh, components, materials);
    const auto planes = trianglePlanes(mesh.welded, edges, deforms ? 0.0 : flatTolerance, threads);
    const auto parts = partsOf(edges.edges.size(), itemsOfThread, threads);
    std::vector<PlanePairCosts> costs(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::vector<OppositePair> paired;
        SideCounts sum;
        std::size_t flatEdges = 0, runs = 0;
        for (std::size_t e = range.first; e < range.end; ++e) {
            const Edge& edge = edges.edges[e];
            SideCounts own;
            pairUp(edges, edge, planes, paired);
            for (const OppositePair& two : paired) {
                own.singles += two.second ? 0 : 1;
                own.pairs += two.second && (deforms || two.first.planeIn(planes) !=
                                                           two.second->planeIn(planes))
                                 ? 1
                                 : 0;
            }
            sum.pairs += own.pairs;
            sum.singles += own.singles;
            flatEdges += own.pairs + own.singles == 0;
            const std::uint32_t triangle = edges.opposites[edge.firstOpposite].triangle;
            runs += sideRunsOf(own, closed[components.ofTriangle[triangle]] != 0);
        }
        costs[part] = costsOf(sum, flatEdges, 0);
        costs[part].sideRuns = runs;
    });
    PlanePairCosts all = costsOf(SideCounts(), 0, mesh.welded.triangles.size());
    for (const PlanePairCosts& one : costs)
        all += one;
    return all;
}

std::vector<std::shared_ptr<const PlanePairShadow>>
buildPlanePairs(const Scene& scene, bool castMasked, double flatTolerance) {
    return byGeometry(scene.batches, [&](std::size_t i) {
        const Batch& batch = scene.batches[i];
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        return std::make_shared<const PlanePairShadow>(
            buildPlanePairs(batch, casters, scene.materials, flatTolerance));
    });
}

} // namespace edgeshade
