#include "preprocess/volumes/cut_caps.hpp"

#include "preprocess/base/reused_vector.hpp"

#include <algorithm>
#include <utility>

namespace edgeshade {
namespace {

/// A part of the caps: of one kind, on one or two sides, visible or away. Parts are in the order of
/// these numbers.
using PartNumber = std::uint8_t;
constexpr std::size_t partsOfKind = 4, partCount = CutCaps::kindCount * partsOfKind;
constexpr std::uint8_t doubleSidedPart = 2, awayPart = 1;

/// A piece as a caster of the cut geometry.
struct PieceCaster {
    Triangle vertices;
    std::uint32_t number; ///< among casters with an area
    std::uint32_t origin; ///< as in CutOrigins
    PartNumber part;      ///< within its kind
};

/// The casters of the cut geometry, numbered without triangles that welding drops.
struct NumberedCasters {
    std::vector<PieceCaster> pieces;
    std::uint32_t firstAway = 0, end = 0;
    std::array<std::size_t, 2> materials{}; ///< one that is visible, one that is cut away
};

/// Also sets `ofCap`: for each cap before the cut its caster's number, or UncutRecords::none.
NumberedCasters numberedCasters(const UncutRecords& uncut, const Geometry& cut,
                                const CutOrigins& origins, const std::vector<Material>& materials,
                                bool castMasked, std::vector<std::uint32_t>& ofCap) {
    NumberedCasters casters;
    ofCap.assign(uncut.shadow->caps.size(), UncutRecords::none);
    std::uint32_t next = 0;
    bool anyAway = false;
    for (const SurfaceGroup& group : cut.groups) {
        const Material& material = materials[group.material];
        if (!material.casts(castMasked)) continue;
        const bool away = !material.isSeen();
        if (away && !anyAway) casters.firstAway = next;
        anyAway = anyAway || away;
        casters.materials[away] = group.material;
        const auto part = static_cast<PartNumber>((material.doubleSided ? doubleSidedPart : 0) |
                                                  (away ? awayPart : 0));
        const std::uint32_t first = group.firstIndex / 3;
        for (std::uint32_t t = first; t < first + group.indexCount / 3; ++t) {
            const std::uint32_t origin = origins.ofTriangle[t];
            if (origin < CutOrigins::piece) {
                const std::uint32_t cap = uncut.capOf[origin];
                if (cap != UncutRecords::none) ofCap[cap] = next++;
                continue;
            }
            const std::uint32_t* const corner = &cut.indices[std::size_t{3} * t];
            const glm::vec3 &a = cut.positions[corner[0]], &b = cut.positions[corner[1]],
                            &c = cut.positions[corner[2]];
            if (a != b && b != c && c != a)
                casters.pieces.push_back({{corner[0], corner[1], corner[2]}, next++, origin, part});
        }
    }
    casters.end = next;
    if (!anyAway) casters.firstAway = next;
    return casters;
}

/// Finds the runs of caps that stay, with their parts within a kind. `ofCap`: of numberedCasters().
void findRuns(const UncutRecords& uncut, std::uint32_t firstAway,
              const std::vector<std::uint32_t>& ofCap, std::vector<CutCaps::Run>& runs) {
    runs.clear();
    CutCaps::Run run{0, 0, 0, 0};
    const auto add = [&](std::uint32_t first, std::uint32_t end, PartNumber sides) {
        for (std::uint32_t cap = first; cap < end; ++cap) {
            const std::uint32_t number = ofCap[cap], component = uncut.componentOf[cap];
            if (number == UncutRecords::none) continue;
            const auto part = static_cast<PartNumber>(sides | (number < firstAway ? 0 : awayPart));
            if (run.end != cap || run.component != component || run.part != part) {
                if (run.end > run.first) runs.push_back(run);
                run = {cap, cap, component, part};
            }
            ++run.end;
        }
    };
    for (const ShadowCluster& cluster : uncut.shadow->clusters) {
        const std::uint32_t others = cluster.caps.first + cluster.singleSided;
        add(cluster.caps.first, others, 0);
        add(others, cluster.caps.end(), doubleSidedPart);
    }
    if (run.end > run.first) runs.push_back(run);
}

/// The component of a piece.
std::uint32_t componentOf(const UncutRecords& uncut, const PieceCaster& piece) {
    return uncut.componentOf[uncut.capOf[piece.origin - CutOrigins::piece]];
}

/// The kind of each component.
std::vector<std::uint8_t> kindsOf(const UncutRecords& uncut, const std::vector<std::uint32_t>& met,
                                  const NumberedCasters& casters,
                                  const std::vector<CutCaps::Run>& runs, std::uint8_t cutKind) {
    std::vector<std::uint8_t> kinds;
    for (const std::uint8_t closed : uncut.closed)
        kinds.push_back(closed != 0 ? CutCaps::closed : CutCaps::open);
    for (const std::uint32_t triangle : met)
        if (const std::uint32_t cap = uncut.capOf[triangle]; cap != UncutRecords::none)
            if (std::uint8_t& kind = kinds[uncut.componentOf[cap]]; kind == CutCaps::closed)
                kind = cutKind;
    if (casters.firstAway == casters.end) return kinds;
    for (const CutCaps::Run& run : runs)
        if ((run.part & awayPart) != 0) kinds[run.component] = CutCaps::tested;
    for (const PieceCaster& piece : casters.pieces)
        if ((piece.part & awayPart) != 0) kinds[componentOf(uncut, piece)] = CutCaps::tested;
    return kinds;
}

/// The ranges of parts, and where the next cap of each goes.
struct PartRanges {
    std::array<std::uint32_t, partCount> count{}, first{}, next{};

    void settle() {
        std::uint32_t sum = 0;
        for (std::size_t i = 0; i < partCount; ++i) {
            first[i] = next[i] = sum;
            sum += count[i];
        }
    }
};

/// Sets the ranges of kinds, and their groups.
void addKinds(const PartRanges& ranges, const NumberedCasters& casters, CutCaps& to) {
    for (std::size_t k = 0; k < CutCaps::kindCount; ++k) {
        CutCaps::Kind& kind = to.kinds[k];
        kind.caps.first = ranges.first[k * partsOfKind];
        for (std::size_t part = 0; part < partsOfKind; ++part) {
            const std::size_t i = k * partsOfKind + part;
            kind.caps.count += ranges.count[i];
            if ((part & doubleSidedPart) == 0) kind.singleSided += ranges.count[i];
            if (k == CutCaps::tested && ranges.count[i] > 0)
                kind.groups.push_back(
                    {casters.materials[part & awayPart], ranges.first[i], ranges.count[i]});
        }
        if (k != CutCaps::tested && kind.caps.count > 0) // all are opaque
            kind.groups.push_back({casters.materials[0], kind.caps.first, kind.caps.count});
    }
}

} // namespace

void findCaps(const UncutRecords& uncut, const Geometry& cut, const CutOrigins& origins,
              const std::vector<Material>& materials, bool castMasked, std::uint8_t cutKind,
              CutCaps& caps) {
    const NumberedCasters casters =
        numberedCasters(uncut, cut, origins, materials, castMasked, caps.capOf);
    findRuns(uncut, casters.firstAway, caps.capOf, caps.runs);
    const std::vector<std::uint8_t> kinds =
        kindsOf(uncut, origins.met, casters, caps.runs, cutKind);

    PartRanges ranges;
    for (CutCaps::Run& run : caps.runs) {
        run.part = static_cast<PartNumber>(kinds[run.component] * partsOfKind + run.part);
        ranges.count[run.part] += run.end - run.first;
    }
    const auto kindOf = [&](const PieceCaster& piece) -> std::size_t {
        return piece.origin == CutOrigins::fill ? cutKind : kinds[componentOf(uncut, piece)];
    };
    for (const PieceCaster& piece : casters.pieces)
        ++ranges.count[kindOf(piece) * partsOfKind + piece.part];
    ranges.settle();
    caps.kinds = {};
    addKinds(ranges, casters, caps);

    resizeReused(caps.caps, casters.end);
    resizeReused(caps.capTriangles, casters.end);
    const std::vector<CapRecord>& before = uncut.shadow->caps;
    for (const CutCaps::Run& run : caps.runs) {
        std::uint32_t to = ranges.next[run.part];
        ranges.next[run.part] += run.end - run.first;
        std::copy(&before[run.first], &before[run.first] + (run.end - run.first), &caps.caps[to]);
        for (std::uint32_t cap = run.first; cap < run.end; ++cap, ++to)
            caps.capTriangles[to] = std::exchange(caps.capOf[cap], to);
    }
    for (const PieceCaster& piece : casters.pieces) {
        const std::size_t kind = kindOf(piece);
        const std::uint32_t to = ranges.next[kind * partsOfKind + piece.part]++;
        caps.kinds[kind].pieces.push_back({piece.vertices, to});
        const auto& [a, b, c] = piece.vertices;
        caps.caps[to] = {cut.positions[a], cut.positions[b], cut.positions[c], glm::vec4(0.0f)};
        caps.capTriangles[to] = piece.number;
    }
    for (const std::uint32_t triangle : origins.met)
        if (const std::uint32_t cap = uncut.capOf[triangle]; cap != UncutRecords::none)
            caps.kinds[kinds[uncut.componentOf[cap]]].met.push_back(cap);
}

} // namespace edgeshade
