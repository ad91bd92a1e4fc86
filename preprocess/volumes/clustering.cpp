#include "preprocess/volumes/clustering.hpp"

#include "preprocess/base/morton.hpp"
#include "preprocess/base/prefetch.hpp"
#include "preprocess/base/radix_sort.hpp"

#include <algorithm>
#include <atomic>

namespace edgeshade {
namespace {

/// Properties of a component that decide its cluster.
struct Part {
    Box bounds;
    bool closed = false;
    bool alphaTested = false;
    std::size_t triangles = 0;
    std::uint64_t place = 0; ///< position on the Morton curve

    std::uint32_t kind() const { return closed ? 0 : alphaTested ? 2 : 1; }
};

/// A box of floats, for corners of triangles.
struct FloatBox {
    glm::vec3 low, high;

    FloatBox() = default;
    explicit FloatBox(const glm::vec3& point) : low(point), high(point) {}
    void add(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

FloatBox boxOf(const WeldedMesh& mesh, const Triangle& triangle) {
    FloatBox box(mesh.positions[triangle[0]]);
    box.add(mesh.positions[triangle[1]]);
    box.add(mesh.positions[triangle[2]]);
    return box;
}

/// The box of each triangle.
std::vector<FloatBox> boxesOf(const WeldedMesh& mesh, Threads threads) {
    std::vector<FloatBox> boxes(mesh.triangles.size());
    forEachItem(boxes.size(), itemsOfThread, threads,
                [&](std::size_t t) { boxes[t] = boxOf(mesh, mesh.triangles[t]); });
    return boxes;
}

/// Consecutive triangles of one component.
struct ComponentRun {
    std::uint32_t component;
    std::uint32_t triangles;
    bool alphaTested;
    FloatBox bounds;
};

/// Appends the runs of triangles [range.first, range.end) in a group's casters.
void addRuns(const std::vector<FloatBox>& boxes, const Components& components,
             const ItemRange& range, bool alphaTested, std::vector<ComponentRun>& runs) {
    const std::size_t before = runs.size();
    for (std::size_t t = range.first; t < range.end; ++t) {
        const std::uint32_t component = components.ofTriangle[t];
        const FloatBox& box = boxes[t];
        if (runs.size() == before || runs.back().component != component) {
            runs.push_back({component, 1, alphaTested, box});
            continue;
        }
        ++runs.back().triangles;
        runs.back().bounds.add(box.low);
        runs.back().bounds.add(box.high);
    }
}

std::vector<Part> componentParts(const CasterMesh& mesh, const std::vector<FloatBox>& boxes,
                                 const Components& components,
                                 const std::vector<Material>& materials, Threads threads) {
    std::vector<Part> parts(components.count());
    for (const MaterialCasters& group : mesh.groups) {
        const bool tested = materials[group.material].alphaMode != AlphaMode::opaque;
        const auto ranges = partsOf(group.capCount, itemsOfThread, threads);
        std::vector<std::vector<ComponentRun>> runs(ranges.size());
        forEachPart(ranges, [&](std::size_t i, const ItemRange& range) {
            addRuns(boxes, components, {group.firstCap + range.first, group.firstCap + range.end},
                    tested, runs[i]);
        });
        for (const auto& ofRange : runs)
            for (const ComponentRun& run : ofRange) {
                Part& part = parts[run.component];
                part.alphaTested = part.alphaTested || run.alphaTested;
                part.triangles += run.triangles;
                part.bounds.add(glm::dvec3(run.bounds.low));
                part.bounds.add(glm::dvec3(run.bounds.high));
            }
    }
    Box all;
    for (const Part& part : parts)
        all.add(part.bounds);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].closed = components.closed[i] && !parts[i].alphaTested;
        parts[i].place = mortonCode(parts[i].bounds.center(), all);
    }
    return parts;
}

/// Sorts by kind, then along the curve.
std::vector<Keyed<3>> orderOf(const std::vector<Part>& parts, Threads threads) {
    std::vector<Keyed<3>> order(parts.size());
    forEachItem(parts.size(), itemsOfThread, threads, [&](std::size_t i) {
        const auto [high, low] = mortonKey(parts[i].place);
        order[i] = {{parts[i].kind(), high, low}, static_cast<std::uint32_t>(i)};
    });
    radixSort(order, threads);
    return order;
}

/// Builds clusters without their triangles; `clusterOf`: by component.
std::vector<TriangleCluster> clustersOf(const std::vector<Part>& parts, Threads threads,
                                        std::vector<std::uint32_t>& clusterOf) {
    std::vector<TriangleCluster> clusters;
    clusterOf.resize(parts.size());
    std::size_t size = 0, end = 0;
    std::uint32_t kind = 0;
    for (const Keyed<3>& item : orderOf(parts, threads)) {
        const Part& part = parts[item.number];
        if (clusters.empty() || part.kind() != kind || size + part.triangles > clusterTriangles) {
            TriangleCluster cluster;
            cluster.closed = part.closed;
            cluster.alphaTested = part.alphaTested;
            cluster.triangles = {end, end};
            clusters.push_back(cluster);
            size = 0;
            kind = part.kind();
        }
        TriangleCluster& cluster = clusters.back();
        size += part.triangles;
        end += part.triangles;
        cluster.triangles.end = end;
        ++cluster.components;
        cluster.bounds.add(part.bounds);
        clusterOf[item.number] = static_cast<std::uint32_t>(clusters.size() - 1);
    }
    return clusters;
}

/// Triangles grouped by cluster, ascending in each.
std::vector<std::uint32_t> byCluster(const Components& components,
                                     const std::vector<std::uint32_t>& clusterOf,
                                     std::size_t clusters, Threads threads) {
    const auto& component = components.ofTriangle;
    // The counts per part and cluster must not need more memory than the triangles.
    const auto parts = partsOf(component.size(), std::max(itemsOfThread, clusters), threads);
    std::vector<std::vector<std::size_t>> places(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        places[part].assign(clusters, 0);
        for (std::size_t t = range.first; t < range.end; ++t)
            ++places[part][clusterOf[component[t]]];
    });
    toPlaces(places);
    std::vector<std::uint32_t> triangles(component.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        for (std::size_t t = range.first; t < range.end; ++t)
            triangles[places[part][clusterOf[component[t]]]++] = static_cast<std::uint32_t>(t);
    });
    return triangles;
}

void sortAlongCurve(const std::vector<FloatBox>& boxes, const Box& bounds,
                    std::span<std::uint32_t> triangles, Threads threads) {
    std::vector<Keyed<2>> order(triangles.size());
    forEachItem(order.size(), itemsOfThread, threads, [&](std::size_t i) {
        const FloatBox& floats = boxes[triangles[i]];
        const Box box{glm::dvec3(floats.low), glm::dvec3(floats.high)};
        order[i] = {mortonKey(mortonCode(box.center(), bounds)), triangles[i]};
    });
    radixSort(order, threads);
    for (std::size_t i = 0; i < order.size(); ++i)
        triangles[i] = order[i].number;
}

/// For each triangle, whether its material is single-sided.
std::vector<std::uint8_t> singleSidedOf(const CasterMesh& mesh,
                                        const std::vector<Material>& materials) {
    std::vector<std::uint8_t> singleSided(mesh.welded.triangles.size(), 0);
    for (const MaterialCasters& group : mesh.groups)
        std::fill_n(singleSided.begin() + group.firstCap, group.capCount,
                    !materials[group.material].doubleSided);
    return singleSided;
}

/// Sorts each cluster's triangles, which come in ascending order.
void orderTriangles(const CasterMesh& mesh, const std::vector<FloatBox>& boxes,
                    const std::vector<Material>& materials, Threads threads,
                    TriangleClusters& all) {
    const std::vector<std::uint8_t> singleSided = singleSidedOf(mesh, materials);
    const auto order = [&](TriangleCluster& cluster, Threads own) {
        const std::span<std::uint32_t> triangles =
            std::span(all.triangles).subspan(cluster.triangles.first, cluster.triangles.size());
        if (!cluster.alphaTested) sortAlongCurve(boxes, cluster.bounds, triangles, own);
        const auto others =
            std::stable_partition(triangles.begin(), triangles.end(),
                                  [&](std::uint32_t t) { return singleSided[t] != 0; });
        cluster.singleSided = static_cast<std::uint32_t>(others - triangles.begin());
    };
    // All threads share a large cluster; small ones take one thread each.
    const auto isLarge = [](const TriangleCluster& cluster) {
        return cluster.triangles.size() > 4 * itemsOfThread;
    };
    for (TriangleCluster& cluster : all.clusters)
        if (isLarge(cluster)) order(cluster, threads);
    inParallel(all.clusters.size(), threads, [&](std::size_t i) {
        if (!isLarge(all.clusters[i])) order(all.clusters[i], {1});
    });
}

/// Gives the clusters their triangles' edges, ascending for each triangle.
void addEdges(const EdgeList& edges, Threads threads, TriangleClusters& all) {
    const std::size_t triangles = all.triangles.size(), count = edges.edges.size();
    std::vector<std::uint32_t> placeOf(triangles); // index in all.triangles
    forEachItem(triangles, itemsOfThread, threads,
                [&](std::size_t i) { placeOf[all.triangles[i]] = static_cast<std::uint32_t>(i); });
    const auto triangleOf = [&](std::size_t e) {
        return edges.opposites[edges.edges[e].firstOpposite].triangle;
    };
    const auto placeOfEdge = [&](std::size_t e) {
        constexpr std::size_t ahead = 16;
        if (e + ahead < count) prefetch(placeOf[triangleOf(e + ahead)]);
        return placeOf[triangleOf(e)];
    };
    std::vector<std::atomic<std::uint32_t>> next(triangles + 1); // counts, then positions
    forEachItem(count, itemsOfThread, threads, [&](std::size_t e) {
        next[placeOfEdge(e)].fetch_add(1, std::memory_order_relaxed);
    });
    std::uint32_t sum = 0;
    for (std::atomic<std::uint32_t>& of : next) {
        const std::uint32_t own = of.load(std::memory_order_relaxed);
        of.store(sum, std::memory_order_relaxed);
        sum += own;
    }
    all.edges.resize(count);
    forEachItem(count, itemsOfThread, threads, [&](std::size_t e) {
        const std::uint32_t place = next[placeOfEdge(e)].fetch_add(1, std::memory_order_relaxed);
        all.edges[place] = static_cast<std::uint32_t>(e);
    });
    // `next` now holds the end of each triangle's edges; threads may have written them in any
    // order.
    forEachItem(triangles, itemsOfThread, threads, [&](std::size_t i) {
        const std::uint32_t first = i == 0 ? 0 : next[i - 1].load(std::memory_order_relaxed);
        const std::uint32_t end = next[i].load(std::memory_order_relaxed);
        if (end - first > 1) std::sort(all.edges.begin() + first, all.edges.begin() + end);
    });
    for (TriangleCluster& cluster : all.clusters)
        cluster.edges = {cluster.triangles.first == 0 ? 0
                                                      : next[cluster.triangles.first - 1].load(),
                         cluster.triangles.end == 0 ? 0 : next[cluster.triangles.end - 1].load()};
}

} // namespace

std::vector<std::uint8_t> countsHalf(const CasterMesh& mesh, const Components& components,
                                     const std::vector<Material>& materials) {
    std::vector<std::uint8_t> half = components.closed;
    for (const MaterialCasters& group : mesh.groups)
        if (materials[group.material].alphaMode != AlphaMode::opaque)
            for (std::uint32_t t = group.firstCap; t < group.firstCap + group.capCount; ++t)
                half[components.ofTriangle[t]] = 0;
    return half;
}

TriangleClusters clusterTrianglesOf(const CasterMesh& mesh, const EdgeList& edges,
                                    const std::vector<Material>& materials, Threads threads) {
    const Components components = findComponents(mesh.welded, edges, threads);
    const std::vector<FloatBox> boxes = boxesOf(mesh.welded, threads);
    TriangleClusters all;
    std::vector<std::uint32_t> clusterOf;
    all.clusters =
        clustersOf(componentParts(mesh, boxes, components, materials, threads), threads, clusterOf);
    all.triangles = byCluster(components, clusterOf, all.clusters.size(), threads);
    orderTriangles(mesh, boxes, materials, threads, all);
    addEdges(edges, threads, all);
    return all;
}

} // namespace edgeshade
