#include "preprocess/volumes/cut_records.hpp"

#include "preprocess/volumes/cap_boxes.hpp"
#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/cut_border.hpp"
#include "preprocess/volumes/side_writer.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Records of crowded edges that are replaced: they may go although their caps stay.
UncutRecords::OfEdge crowdedOf(const UncutRecords& uncut,
                               const std::vector<std::uint32_t>& replaced) {
    UncutRecords::OfEdge all;
    for (const auto& [edge, of] : uncut.crowded) {
        if (!std::binary_search(replaced.begin(), replaced.end(), edge)) continue;
        all.pairs.insert(all.pairs.end(), of.pairs.begin(), of.pairs.end());
        all.singles.insert(all.singles.end(), of.singles.begin(), of.singles.end());
    }
    std::sort(all.pairs.begin(), all.pairs.end());
    std::sort(all.singles.begin(), all.singles.end());
    return all;
}

/// Calls visit(i) for i in [0, count) without those in `skipped`, which are ascending.
template <class Visit>
void forOthers(std::size_t count, const std::vector<std::uint32_t>& skipped, const Visit& visit) {
    std::size_t i = 0;
    for (const std::uint32_t skip : skipped) {
        for (; i < skip; ++i)
            visit(i);
        i = std::size_t{skip} + 1;
    }
    for (; i < count; ++i)
        visit(i);
}

PlaneOf planeAt(std::uint32_t cap, PlaneOf before) {
    return {2 * cap + (before.negated() ? 1u : 0u)};
}

/// Copies the records of edges whose caps all stay as they were.
void addUnchanged(const UncutRecords& uncut, const CutBorder& border,
                  const std::vector<std::uint32_t>& capOf, PlanePairShadow& to) {
    const PlanePairShadow& from = *uncut.shadow;
    const UncutRecords::OfEdge skipped = crowdedOf(uncut, border.replaced);
    forOthers(from.pairs.size(), skipped.pairs, [&](std::size_t i) {
        const auto& [first, second] = from.pairPlanes[i];
        const std::uint32_t cap = capOf[first.cap()], other = capOf[second.cap()];
        if (cap == UncutRecords::none || other == UncutRecords::none) return;
        to.pairs.push_back(from.pairs[i]);
        to.pairPlanes.push_back({planeAt(cap, first), planeAt(other, second)});
    });
    forOthers(from.singles.size(), skipped.singles, [&](std::size_t i) {
        const std::uint32_t cap = capOf[from.singlePlanes[i].cap()];
        if (cap == UncutRecords::none) return;
        to.singles.push_back(from.singles[i]);
        to.singlePlanes.push_back(planeAt(cap, from.singlePlanes[i]));
    });
}

/// Counts the edges whose caps all stay as they were, and those of them without a record.
void countUnchanged(const UncutRecords& uncut, const CutBorder& border,
                    const std::vector<std::uint32_t>& capOf, PlanePairShadow& to) {
    for (std::size_t cap = 0; cap < capOf.size(); ++cap)
        if (capOf[cap] != UncutRecords::none) {
            to.edges += uncut.edgesFrom[cap];
            to.flatEdges += uncut.flatFrom[cap];
        }
    for (const std::uint32_t edge : border.replaced)
        if (capOf[uncut.capsOf(edge).front()] != UncutRecords::none) {
            --to.edges;
            to.flatEdges -= uncut.flat[edge];
        }
}

/// Adds the records of the border's edges.
void addBorder(const CutBorder& border, PlanePairShadow& to) {
    SideWriter writer(border.mesh, border.edges, border.planes, border.capOf);
    writer.pair = to.pairs.size();
    writer.single = to.singles.size();
    std::size_t pairs = writer.pair, singles = writer.single;
    for (const Edge& edge : border.edges.edges) {
        pairs += edge.oppositeCount / 2;
        singles += edge.oppositeCount % 2;
    }
    to.pairs.resize(pairs);
    to.pairPlanes.resize(pairs);
    to.singles.resize(singles);
    to.singlePlanes.resize(singles);
    for (const Edge& edge : border.edges.edges)
        writer.write(edge, to, nullptr);
    to.pairs.resize(writer.pair);
    to.pairPlanes.resize(writer.pair);
    to.edges += border.edges.edges.size();
    to.flatEdges += writer.flatEdges;
}

template <class Record>
RecordRange allOf(const std::vector<Record>& records) {
    return {0, static_cast<std::uint32_t>(records.size())};
}

void addCluster(bool closed, const CutCaps& caps, PlanePairShadow& to) {
    ShadowCluster cluster;
    cluster.alphaTested = caps.away > 0;
    cluster.closed = closed && !cluster.alphaTested;
    cluster.components = ShadowCluster::uncounted;
    cluster.pairs = allOf(to.pairs);
    cluster.singles = allOf(to.singles);
    cluster.caps = allOf(to.caps);
    cluster.singleSided = caps.singleSided;
    cluster.groups = allOf(to.groups);
    cluster.leaves = {0, (cluster.caps.count + leafTriangles - 1) / leafTriangles};
    to.clusters.push_back(cluster);
    addLeaves({1}, to);
    for (const Box& leaf : to.leaves)
        to.clusters.front().bounds.add(leaf);
}

/// The records without any, but for the memory of their arrays.
PlanePairShadow emptied(PlanePairShadow records) {
    PlanePairShadow empty;
    const auto keep = [](auto& from, auto& to) {
        from.clear();
        to = std::move(from);
    };
    keep(records.pairs, empty.pairs);
    keep(records.pairPlanes, empty.pairPlanes);
    keep(records.singles, empty.singles);
    keep(records.singlePlanes, empty.singlePlanes);
    keep(records.caps, empty.caps);
    keep(records.capTriangles, empty.capTriangles);
    keep(records.leaves, empty.leaves);
    return empty;
}

} // namespace

PlanePairShadow cutRecords(const UncutRecords& uncut, const Geometry& cut,
                           const CutOrigins& origins, const std::vector<Material>& materials,
                           bool castMasked, PlanePairShadow spare) {
    PlanePairShadow made = emptied(std::move(spare));
    CutCaps caps;
    caps.caps = std::move(made.caps);
    caps.capTriangles = std::move(made.capTriangles);
    findCaps(uncut, cut, origins, materials, castMasked, caps);
    if (caps.caps.empty()) return made;
    const CutBorder border = cutBorder(uncut, origins.met, caps);
    for (std::size_t i = 0; i < caps.pieces.size(); ++i)
        caps.caps[caps.pieces[i].cap].plane = border.planes[i];
    made.caps = std::move(caps.caps);
    made.capTriangles = std::move(caps.capTriangles);
    made.groups = std::move(caps.groups);

    const std::size_t borderPairs = border.edges.opposites.size() / 2;
    made.pairs.reserve(uncut.shadow->pairs.size() + borderPairs);
    made.pairPlanes.reserve(uncut.shadow->pairs.size() + borderPairs);
    addUnchanged(uncut, border, caps.capOf, made);
    countUnchanged(uncut, border, caps.capOf, made);
    addBorder(border, made);
    // Each edge of n triangles has n / 2 pairs, and a single if n is odd.
    made.flatPairs = (3 * made.caps.size() - made.singles.size()) / 2 - made.pairs.size();
    addCluster(uncut.shadow->clusters.front().closed && border.balanced, caps, made);
    return made;
}

} // namespace edgeshade
