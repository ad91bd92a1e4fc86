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
    if (uncut.crowded.empty()) return all;
    for (const std::uint32_t edge : replaced) {
        const auto found = uncut.crowded.find(edge);
        if (found == uncut.crowded.end()) continue;
        const auto& [pairs, singles] = found->second;
        all.pairs.insert(all.pairs.end(), pairs.begin(), pairs.end());
        all.singles.insert(all.singles.end(), singles.begin(), singles.end());
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

/// Copies the records of edges whose caps all stay as they were, and are among `caps`.
void addUnchanged(const UncutRecords& uncut, const std::vector<std::uint32_t>& replaced,
                  const std::vector<std::uint32_t>& capOf, const RecordRange& caps,
                  PlanePairShadow& to) {
    const PlanePairShadow& from = *uncut.shadow;
    const UncutRecords::OfEdge skipped = crowdedOf(uncut, replaced);
    const auto isOneOf = [&](std::uint32_t cap) { return cap - caps.first < caps.count; };
    forOthers(from.pairs.size(), skipped.pairs, [&](std::size_t i) {
        const auto& [first, second] = from.pairPlanes[i];
        const std::uint32_t cap = capOf[first.cap()], other = capOf[second.cap()];
        if (!isOneOf(cap) || !isOneOf(other)) return; // nor is UncutRecords::none
        to.pairs.push_back(from.pairs[i]);
        to.pairPlanes.push_back({planeAt(cap, first), planeAt(other, second)});
    });
    forOthers(from.singles.size(), skipped.singles, [&](std::size_t i) {
        const std::uint32_t cap = capOf[from.singlePlanes[i].cap()];
        if (!isOneOf(cap)) return;
        to.singles.push_back(from.singles[i]);
        to.singlePlanes.push_back(planeAt(cap, from.singlePlanes[i]));
    });
}

/// Counts the edges that list a cap first which stays as it was, and those of them without a
/// record.
void countUncut(const UncutRecords& uncut, const std::vector<std::uint32_t>& capOf,
                PlanePairShadow& to) {
    for (std::size_t cap = 0; cap < capOf.size(); ++cap)
        if (capOf[cap] != UncutRecords::none) {
            to.edges += uncut.edgesFrom[cap];
            to.flatEdges += uncut.flatFrom[cap];
        }
}

/// Takes edges that are replaced from the counts.
void discountReplaced(const UncutRecords& uncut, const std::vector<std::uint32_t>& replaced,
                      const std::vector<std::uint32_t>& capOf, PlanePairShadow& to) {
    for (const std::uint32_t edge : replaced)
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

/// The records of `records` after `range`.
template <class Record>
RecordRange restAfter(const RecordRange& range, const std::vector<Record>& records) {
    return {range.end(), static_cast<std::uint32_t>(records.size()) - range.end()};
}

/// Adds the cluster of a kind, whose records are the last ones.
void addCluster(const CutCaps::Kind& kind, bool closed, bool alphaTested, PlanePairShadow& to) {
    const ShadowCluster last = to.clusters.empty() ? ShadowCluster() : to.clusters.back();
    to.groups.insert(to.groups.end(), kind.groups.begin(), kind.groups.end());
    ShadowCluster cluster;
    cluster.closed = closed;
    cluster.alphaTested = alphaTested;
    cluster.components = ShadowCluster::uncounted;
    cluster.pairs = restAfter(last.pairs, to.pairs);
    cluster.singles = restAfter(last.singles, to.singles);
    cluster.caps = kind.caps;
    cluster.singleSided = kind.singleSided;
    cluster.groups = restAfter(last.groups, to.groups);
    cluster.leaves = {last.leaves.end(), (kind.caps.count + leafTriangles - 1) / leafTriangles};
    to.clusters.push_back(cluster);
}

void addBoxes(PlanePairShadow& to) {
    addLeaves({1}, to);
    for (ShadowCluster& cluster : to.clusters)
        for (std::uint32_t leaf = cluster.leaves.first; leaf < cluster.leaves.end(); ++leaf)
            cluster.bounds.add(to.leaves[leaf]);
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
    keep(records.leaves, empty.leaves);
    return empty;
}

} // namespace

PlanePairShadow cutRecords(const UncutRecords& uncut, const Geometry& cut,
                           const CutOrigins& origins, const std::vector<Material>& materials,
                           bool castMasked, PlanePairShadow spare) {
    CutCaps caps;
    caps.caps = std::move(spare.caps);
    caps.capTriangles = std::move(spare.capTriangles);
    std::array<CutBorder, CutCaps::kindCount> borders;
    const auto find = [&](std::uint8_t cutKind) {
        findCaps(uncut, cut, origins, materials, castMasked, cutKind, caps);
        for (std::size_t k = 0; k < CutCaps::kindCount; ++k)
            borders[k] = cutBorder(uncut, cut, caps, caps.kinds[k]);
    };
    find(CutCaps::closed);
    if (!borders[CutCaps::closed].balanced) find(CutCaps::open);

    PlanePairShadow made = emptied(std::move(spare));
    made.pairs.reserve(uncut.shadow->pairs.size());
    made.pairPlanes.reserve(uncut.shadow->pairs.size());
    countUncut(uncut, caps.capOf, made);
    for (std::size_t k = 0; k < CutCaps::kindCount; ++k) {
        const CutCaps::Kind& kind = caps.kinds[k];
        if (kind.caps.count == 0) continue;
        const CutBorder& border = borders[k];
        for (std::size_t i = 0; i < kind.pieces.size(); ++i)
            caps.caps[kind.pieces[i].cap].plane = border.planes[i];
        discountReplaced(uncut, border.replaced, caps.capOf, made);
        addUnchanged(uncut, border.replaced, caps.capOf, kind.caps, made);
        addBorder(border, made);
        addCluster(kind, k == CutCaps::closed, k == CutCaps::tested, made);
    }
    made.caps = std::move(caps.caps);
    made.capTriangles = std::move(caps.capTriangles);
    // Each edge of n triangles has n / 2 pairs, and a single if n is odd.
    made.flatPairs = (3 * made.caps.size() - made.singles.size()) / 2 - made.pairs.size();
    addBoxes(made);
    return made;
}

} // namespace edgeshade
