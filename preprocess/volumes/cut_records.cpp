#include "preprocess/volumes/cut_records.hpp"

#include "preprocess/base/reused_vector.hpp"
#include "preprocess/volumes/cap_boxes.hpp"
#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/side_writer.hpp"

#include <algorithm>
#include <numeric>

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

/// The places in a PlanePairShadow where the next records go. Its arrays are long enough.
struct RecordEnds {
    std::size_t pair = 0, single = 0;
};

/// Copies the records of edges whose caps all stay as they were, and are among `caps`.
void addUnchanged(const UncutRecords& uncut, const std::vector<std::uint32_t>& replaced,
                  const std::vector<std::uint32_t>& capOf, const RecordRange& caps,
                  PlanePairShadow& to, RecordEnds& end) {
    const PlanePairShadow& from = *uncut.shadow;
    const UncutRecords::OfEdge skipped = crowdedOf(uncut, replaced);
    // False for UncutRecords::none.
    const auto isOneOf = [&](std::uint32_t cap) { return cap - caps.first < caps.count; };
    // Some numbers first, without a branch, since which records stay is hard to predict.
    std::array<std::uint32_t, 1024> unchanged;
    std::size_t count = 0;
    const auto copy = [&] {
        for (const std::uint32_t i : std::span(unchanged).first(count)) {
            const auto& [first, second] = from.pairPlanes[i];
            to.pairs[end.pair] = from.pairs[i];
            to.pairPlanes[end.pair] = {planeAt(capOf[first.cap()], first),
                                       planeAt(capOf[second.cap()], second)};
            ++end.pair;
        }
        count = 0;
    };
    forOthers(from.pairs.size(), skipped.pairs, [&](std::size_t i) {
        const auto& [first, second] = from.pairPlanes[i];
        unchanged[count] = static_cast<std::uint32_t>(i);
        count +=
            std::size_t{isOneOf(capOf[first.cap()])} & std::size_t{isOneOf(capOf[second.cap()])};
        if (count == unchanged.size()) copy();
    });
    copy();
    forOthers(from.singles.size(), skipped.singles, [&](std::size_t i) {
        const std::uint32_t cap = capOf[from.singlePlanes[i].cap()];
        if (!isOneOf(cap)) return;
        to.singles[end.single] = from.singles[i];
        to.singlePlanes[end.single] = planeAt(cap, from.singlePlanes[i]);
        ++end.single;
    });
}

/// Counts the edges that list a cap first which stays as it was, and those of them without a
/// record.
void countUncut(const UncutRecords& uncut, const std::vector<CutCaps::Run>& runs,
                PlanePairShadow& to) {
    const auto sum = [](const std::vector<std::uint8_t>& counts, const CutCaps::Run& run) {
        return std::accumulate(&counts[run.first], &counts[run.first] + (run.end - run.first), 0u);
    };
    for (const CutCaps::Run& run : runs) {
        to.edges += sum(uncut.edgesFrom, run);
        to.flatEdges += sum(uncut.flatFrom, run);
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
void addBorder(const CutBorder& border, PlanePairShadow& to, RecordEnds& end) {
    SideWriter writer(border.positions, border.edges, border.planes, border.capOf);
    writer.pair = end.pair;
    writer.single = end.single;
    for (const Edge& edge : border.edges.edges)
        writer.write(edge, to, nullptr);
    end = {writer.pair, writer.single};
    to.edges += border.edges.edges.size();
    to.flatEdges += writer.flatEdges;
}

/// The range from another's end to `end`.
RecordRange restAfter(const RecordRange& range, std::size_t end) {
    return {range.end(), static_cast<std::uint32_t>(end) - range.end()};
}

/// Adds the cluster of a kind, whose records are the last ones.
void addCluster(const CutCaps::Kind& kind, bool closed, bool alphaTested, const RecordEnds& end,
                PlanePairShadow& to) {
    const ShadowCluster last = to.clusters.empty() ? ShadowCluster() : to.clusters.back();
    to.groups.insert(to.groups.end(), kind.groups.begin(), kind.groups.end());
    ShadowCluster cluster;
    cluster.closed = closed;
    cluster.alphaTested = alphaTested;
    cluster.components = ShadowCluster::uncounted;
    cluster.pairs = restAfter(last.pairs, end.pair);
    cluster.singles = restAfter(last.singles, end.single);
    cluster.caps = kind.caps;
    cluster.singleSided = kind.singleSided;
    cluster.groups = restAfter(last.groups, to.groups.size());
    cluster.leaves = {last.leaves.end(), (kind.caps.count + leafTriangles - 1) / leafTriangles};
    to.clusters.push_back(cluster);
}

void addBoxes(PlanePairShadow& to) {
    addLeaves({1}, to);
    for (ShadowCluster& cluster : to.clusters)
        for (std::uint32_t leaf = cluster.leaves.first; leaf < cluster.leaves.end(); ++leaf)
            cluster.bounds.add(to.leaves[leaf]);
}

/// Records whose arrays are as long as they may become, and reuse the memory of others.
PlanePairShadow roomFor(const UncutRecords& uncut,
                        const std::array<CutBorder, CutCaps::kindCount>& borders,
                        PlanePairShadow spare) {
    RecordEnds most{uncut.shadow->pairs.size(), uncut.shadow->singles.size()};
    for (const CutBorder& border : borders)
        for (const Edge& edge : border.edges.edges) {
            most.pair += edge.oppositeCount / 2;
            most.single += edge.oppositeCount % 2;
        }
    PlanePairShadow made;
    const auto reuse = [](auto& from, auto& to, std::size_t count) {
        to = std::move(from);
        resizeReused(to, count);
    };
    reuse(spare.pairs, made.pairs, most.pair);
    reuse(spare.pairPlanes, made.pairPlanes, most.pair);
    reuse(spare.singles, made.singles, most.single);
    reuse(spare.singlePlanes, made.singlePlanes, most.single);
    made.leaves = std::move(spare.leaves);
    return made;
}

} // namespace

PlanePairShadow cutRecords(const UncutRecords& uncut, const Geometry& cut,
                           const CutOrigins& origins, const std::vector<Material>& materials,
                           bool castMasked, CutMemory& memory, PlanePairShadow spare) {
    CutCaps& caps = memory.caps;
    caps.caps = std::move(spare.caps);
    caps.capTriangles = std::move(spare.capTriangles);
    std::array<CutBorder, CutCaps::kindCount> borders;
    const auto find = [&](std::uint8_t cutKind) {
        findCaps(uncut, cut, origins, materials, castMasked, cutKind, caps);
        for (std::size_t k = 0; k < CutCaps::kindCount; ++k)
            borders[k] = cutBorder(uncut, cut, caps, caps.kinds[k], memory.numbers);
    };
    find(CutCaps::closed);
    if (!borders[CutCaps::closed].balanced) find(CutCaps::open);

    PlanePairShadow made = roomFor(uncut, borders, std::move(spare));
    RecordEnds end;
    countUncut(uncut, caps.runs, made);
    for (std::size_t k = 0; k < CutCaps::kindCount; ++k) {
        const CutCaps::Kind& kind = caps.kinds[k];
        if (kind.caps.count == 0) continue;
        const CutBorder& border = borders[k];
        for (std::size_t i = 0; i < kind.pieces.size(); ++i)
            caps.caps[kind.pieces[i].cap].plane = border.planes[i];
        discountReplaced(uncut, border.replaced, caps.capOf, made);
        addUnchanged(uncut, border.replaced, caps.capOf, kind.caps, made, end);
        addBorder(border, made, end);
        addCluster(kind, k == CutCaps::closed, k == CutCaps::tested, end, made);
    }
    made.pairs.resize(end.pair);
    made.pairPlanes.resize(end.pair);
    made.singles.resize(end.single);
    made.singlePlanes.resize(end.single);
    made.caps = std::move(caps.caps);
    made.capTriangles = std::move(caps.capTriangles);
    // Each edge of n triangles has n / 2 pairs, and a single if n is odd.
    made.flatPairs = (3 * made.caps.size() - made.singles.size()) / 2 - made.pairs.size();
    addBoxes(made);
    return made;
}

} // namespace edgeshade
