#include "src/shadow/primitive_map/texel_occluders.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Most pairs of a light-facing triangle and one facing away for which a group is examined.
constexpr std::size_t mostPairs = 64;

/// Beyond all depths that occur in floats.
constexpr double nowhere = 1e30;

/// Upper limit of a plane's tolerance for joining depths. For steeper planes lists would get too
/// long for the gain in accuracy.
constexpr double mostTolerance = 32.0 * mapRounding;

struct Touching {
    std::uint32_t print;
    Interval depths; ///< in the square
};

/// Footprints whose depths overlap, in one square (docs/method.md, C34). If no contour passes
/// through the square, every ray meets equally many of them.
struct DepthGroup {
    std::span<const Touching> members;
    double farthest = 0.0;
    bool constant = true; ///< every ray meets equally many of either facing
    int facing = 0, away = 0;

    int cover() const { return facing + away; }
};

class GroupFinder {
  public:
    GroupFinder(const TileFootprints& tile, const RaySquare& square)
        : tile_(tile), square_(square), sample_(square.center()) {}

    /// The next group of footprints, sorted by nearest depth, from `first` on.
    DepthGroup groupFrom(std::span<const Touching> sorted, std::size_t first) const {
        DepthGroup group;
        std::size_t end = first;
        double farthest = -std::numeric_limits<double>::infinity();
        for (; end < sorted.size() && (end == first || sorted[end].depths.low <= farthest); ++end) {
            farthest = std::max(farthest, sorted[end].depths.high);
            add(sorted[end], group);
        }
        group.members = sorted.subspan(first, end - first);
        group.farthest = farthest;
        return group;
    }

    /// Whether each ray meets one light-facing triangle of the group, before all that face away: no
    /// light-facing caster of the group is in another's shadow.
    bool isLitSheet(const DepthGroup& group) const {
        if (tile_.spread.any()) return group.cover() == 1 && goesOn(group);
        if (group.cover() == 1) return true;
        if (group.facing != 1) return false;
        std::vector<std::uint32_t> before, behind;
        for (const Touching& member : group.members)
            (occluderOf(member).lightFacing ? before : behind).push_back(member.print);
        if (before.size() * behind.size() > mostPairs) return false;
        return std::all_of(before.begin(), before.end(), [&](std::uint32_t b) {
            return std::all_of(behind.begin(), behind.end(), [&](std::uint32_t f) {
                return isBefore(tile_.prints[b], tile_.prints[f]);
            });
        });
    }

    /// Whether segments that end within a group never meet more of it than those that continue
    /// through it.
    bool goesOn(const DepthGroup& group) const {
        return tile_.spread.mayGoOn({group.members.front().depths.low, group.farthest});
    }

  private:
    const Occluder& occluderOf(const Touching& member) const {
        return tile_.occluders[tile_.prints[member.print].occluder];
    }

    void add(const Touching& member, DepthGroup& group) const {
        const Footprint& print = tile_.prints[member.print];
        const Occluder& occluder = tile_.occluders[print.occluder];
        if (occluder.mixed || print.nearLight) group.constant = false;
        if (!group.constant) return;
        const RaySquare met = tile_.spread.grown(square_, member.depths.low);
        for (int i = 0; i < 3 && group.constant; ++i)
            if ((occluder.contours >> i & 1u) != 0 && print.mayCross(i, met))
                group.constant = false;
        if (!group.constant) return;
        const std::optional<bool> covers = print.covers(sample_, occluder);
        if (!covers)
            group.constant = false;
        else if (*covers && occluder.blocks)
            ++(occluder.lightFacing ? group.facing : group.away);
    }

    /// Whether a's plane is nearer than b's on all rays of the square.
    bool isBefore(const Footprint& a, const Footprint& b) const {
        // These are linear over the square: depths, or for a point light their inverses.
        const glm::dvec3 apart = tile_.directional ? b.plane - a.plane : a.plane - b.plane;
        for (int i = 0; i < 4; ++i)
            if (!(glm::dot(apart, square_.corner(i)) >= 0.0)) return false;
        return true;
    }

    const TileFootprints& tile_;
    const RaySquare& square_;
    glm::dvec3 sample_;
};

/// The depths at which segments from a square may meet a footprint; null: they don't.
std::optional<Interval> depthsMet(const Footprint& print, const TileFootprints& tile,
                                  const RaySquare& square) {
    if (print.nearLight) return Interval{-nowhere, print.depths.high};
    RaySquare met = tile.spread.grown(square, print.depths.low);
    if (!print.mayTouch(met)) return std::nullopt;
    Interval depths = print.depthsIn(met, tile.directional);
    if (!tile.spread.any()) return depths;
    met = tile.spread.grown(square, depths.low); // no segment meets it nearer than this
    if (!print.mayTouch(met)) return std::nullopt;
    return print.depthsIn(met, tile.directional);
}

/// The distance that depths need for lookups to distinguish them: points may be off by rounding,
/// and a point behind a plane by less than its tolerance may be on it (primitive_map_lookup.glsl).
double roomOf(const Footprint& print, const Interval& depths, bool directional) {
    const double terms =
        std::abs(print.plane.x) + std::abs(print.plane.y) + std::abs(print.plane.z);
    const double tolerance = std::min(2.0 * mapRounding * (1.0 + terms), mostTolerance);
    return mapRounding + (directional ? tolerance : tolerance * std::min(depths.high, 1.0));
}

/// Lists triangles that may have holes; none is known to block a ray.
void addCutouts(std::span<const Touching> cutouts, TexelOccluders& result) {
    const std::size_t solid = result.listed.size();
    for (const Touching& cutout : cutouts) {
        if (cutout.depths.low > result.darkBehind) continue;
        result.listed.push_back({cutout.print, cutout.depths.low});
        result.touching.push_back(cutout.print);
    }
    if (result.listed.size() == solid) return;
    std::sort(result.listed.begin(), result.listed.end(),
              [](const ListedOccluder& a, const ListedOccluder& b) {
                  return a.nearest != b.nearest ? a.nearest < b.nearest : a.print < b.print;
              });
    result.forCasters = result.listed.size();
}

} // namespace

void findOccluders(const TileFootprints& tile, std::span<const std::uint32_t> candidates,
                   const RaySquare& square, bool othersReceive, TexelOccluders& result) {
    result.darkBehind = std::numeric_limits<double>::infinity();
    result.listed.clear();
    result.touching.clear();
    static thread_local std::vector<Touching> touching, cutouts;
    touching.clear();
    cutouts.clear();
    for (const std::uint32_t candidate : candidates) {
        const Footprint& print = tile.prints[candidate];
        const std::optional<Interval> depths = depthsMet(print, tile, square);
        if (!depths) continue;
        const double room = roomOf(print, *depths, tile.directional);
        (tile.occluders[print.occluder].isSolid() ? touching : cutouts)
            .push_back({candidate, {depths->low - room, depths->high + room}});
    }
    std::sort(touching.begin(), touching.end(), [](const Touching& a, const Touching& b) {
        return a.depths.low != b.depths.low ? a.depths.low < b.depths.low : a.print < b.print;
    });
    const GroupFinder finder(tile, square);
    const auto list = [&](const DepthGroup& group) {
        for (const Touching& member : group.members)
            result.listed.push_back({member.print, member.depths.low});
    };
    std::size_t next = 0;
    bool terminal = false;
    while (next < touching.size() && !terminal) {
        const DepthGroup group = finder.groupFrom(touching, next);
        next += group.members.size();
        terminal = group.constant && group.cover() > 0;
        if (!terminal) {
            if (!group.constant || !finder.goesOn(group)) list(group); // otherwise no ray meets it
            result.forCasters = result.listed.size();
            continue;
        }
        result.darkBehind = group.farthest;
        result.forCasters = result.listed.size();
        const bool sheet = finder.isLitSheet(group);
        if (!sheet || group.cover() > 1 || othersReceive) list(group);
        if (!sheet) result.forCasters = result.listed.size();
    }
    if (touching.empty()) result.forCasters = 0;
    for (std::size_t i = 0; i < next; ++i)
        result.touching.push_back(touching[i].print);
    addCutouts(cutouts, result);
}

} // namespace edgeshade
