#include "src/shadow/plan/solid_clusters.hpp"

#include "preprocess/base/disjoint_sets.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

namespace edgeshade {
namespace {

using Corners = std::array<glm::dvec3, 3>;

/// Some units of rounding of products of coordinates, as a share of them.
constexpr double rounding = 1e-14;

Corners cornersOf(const CapRecord& cap) {
    return {glm::dvec3(cap.a), glm::dvec3(cap.b), glm::dvec3(cap.c)};
}

Box boxAround(const Corners& corners) {
    Box box;
    for (const glm::dvec3& corner : corners)
        box.add(corner);
    return box;
}

bool overlap(const Box& one, const Box& other) {
    return glm::all(glm::lessThanEqual(one.low, other.high)) &&
           glm::all(glm::lessThanEqual(other.low, one.high));
}

/// What the triangles are along an axis: their least and most.
std::pair<double, double> along(const glm::dvec3& axis, const Corners& corners,
                                const glm::dvec3& from) {
    const double a = glm::dot(axis, corners[0] - from), b = glm::dot(axis, corners[1] - from),
                 c = glm::dot(axis, corners[2] - from);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

/// Whether two triangles have more in common than a contact: no plane parts them, they themselves
/// on it allowed (separating axes, Gottschalk et al. 1996).
bool cross(const Corners& one, const Corners& other) {
    const glm::dvec3& from = one[0];
    double size = 0.0;
    for (const Corners* corners : {&one, &other})
        for (const glm::dvec3& corner : *corners)
            size = std::max(size, glm::length(corner - from));
    const auto parts = [&](const glm::dvec3& axis) {
        const double slack = rounding * size * glm::length(axis);
        const auto [low, high] = along(axis, one, from);
        const auto [otherLow, otherHigh] = along(axis, other, from);
        return high <= otherLow + slack || otherHigh <= low + slack;
    };
    const auto edge = [](const Corners& of, int i) { return of[(i + 1) % 3] - of[i]; };
    const glm::dvec3 normal = glm::cross(edge(one, 0), edge(one, 1)),
                     otherNormal = glm::cross(edge(other, 0), edge(other, 1));
    const auto [low, high] = along(normal, other, from);
    const double slack = rounding * size * glm::length(normal);
    const bool flat = low >= -slack && high <= slack;
    if (!flat) {
        if (parts(normal) || parts(otherNormal)) return false;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (const glm::dvec3 axis = glm::cross(edge(one, i), edge(other, j));
                    glm::dot(axis, axis) > 0.0 && parts(axis))
                    return false;
        return true;
    }
    for (int i = 0; i < 3; ++i)
        for (const Corners* corners : {&one, &other})
            if (parts(glm::cross(normal, edge(*corners, i)))) return false;
    return true;
}

/// Boxes around halves of a list of triangles, and halves of these.
class Halves {
  public:
    explicit Halves(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
        boxes_.resize(4 * triangles_.size() + 4);
        fill({1, 0, triangles_.size()});
    }

    bool anyCross() const { return crossWithin({1, 0, triangles_.size()}); }

  private:
    static constexpr std::size_t few = 4;
    struct Part {
        std::size_t number, first, end; ///< that of the whole is 1
        bool whole() const { return end - first <= few; }
        Part half(bool second) const {
            const std::size_t middle = first + (end - first) / 2;
            return second ? Part{2 * number + 1, middle, end} : Part{2 * number, first, middle};
        }
    };

    void fill(const Part& part) {
        Box& box = boxes_[part.number];
        if (part.whole()) {
            for (std::size_t i = part.first; i < part.end; ++i)
                for (const glm::dvec3& corner : triangles_[i])
                    box.add(corner);
            return;
        }
        for (const bool second : {false, true}) {
            const Part half = part.half(second);
            fill(half);
            box.add(boxes_[half.number].low);
            box.add(boxes_[half.number].high);
        }
    }

    bool meet(std::size_t i, std::size_t j) const {
        return overlap(boxAround(triangles_[i]), boxAround(triangles_[j])) &&
               cross(triangles_[i], triangles_[j]);
    }

    bool crossWithin(const Part& part) const {
        if (part.whole()) {
            for (std::size_t i = part.first; i < part.end; ++i)
                for (std::size_t j = i + 1; j < part.end; ++j)
                    if (meet(i, j)) return true;
            return false;
        }
        const Part first = part.half(false), second = part.half(true);
        return crossWithin(first) || crossWithin(second) || crossBetween(first, second);
    }

    bool crossBetween(const Part& one, const Part& other) const {
        if (!overlap(boxes_[one.number], boxes_[other.number])) return false;
        if (one.whole() && other.whole()) {
            for (std::size_t i = one.first; i < one.end; ++i)
                for (std::size_t j = other.first; j < other.end; ++j)
                    if (meet(i, j)) return true;
            return false;
        }
        const bool divideOne =
            !one.whole() && (other.whole() || one.end - one.first >= other.end - other.first);
        const Part& divided = divideOne ? one : other;
        const Part& kept = divideOne ? other : one;
        return crossBetween(divided.half(false), kept) || crossBetween(divided.half(true), kept);
    }

    std::vector<Corners> triangles_;
    std::vector<Box> boxes_; ///< by number
};

bool isOutwards(const std::vector<Corners>& triangles) {
    const glm::dvec3 from = triangles.front()[0];
    double volume = 0.0;
    for (const Corners& t : triangles)
        volume += glm::dot(t[0] - from, glm::cross(t[1] - from, t[2] - from));
    return volume > 0.0;
}

/// A triangle's way through an edge: the edge's ends in order, and whether it runs against that.
struct Way {
    std::array<glm::vec3, 2> ends;
    std::uint32_t triangle;
    bool against;

    auto key() const {
        const auto& [a, b] = ends;
        return std::make_tuple(a.x, a.y, a.z, b.x, b.y, b.z);
    }
};

/// The cluster's triangles by component; nothing where an edge has not two, which run opposite
/// ways.
std::vector<std::vector<Corners>> manifoldParts(std::span<const CapRecord> caps) {
    std::vector<Way> ways;
    ways.reserve(3 * caps.size());
    for (std::uint32_t t = 0; t < caps.size(); ++t) {
        const std::array<glm::vec3, 3> corners = {caps[t].a, caps[t].b, caps[t].c};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 &a = corners[i], &b = corners[(i + 1) % 3];
            const bool against = std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z);
            ways.push_back({against ? std::array{b, a} : std::array{a, b}, t, against});
        }
    }
    std::sort(ways.begin(), ways.end(),
              [](const Way& one, const Way& other) { return one.key() < other.key(); });
    DisjointSets sets(caps.size());
    for (std::size_t i = 0; i < ways.size(); i += 2) {
        const bool pair = i + 1 < ways.size() && ways[i].key() == ways[i + 1].key() &&
                          ways[i].against != ways[i + 1].against;
        const bool more = i + 2 < ways.size() && ways[i].key() == ways[i + 2].key();
        if (!pair || more) return {};
        sets.unite(ways[i].triangle, ways[i + 1].triangle);
    }
    std::map<std::size_t, std::vector<Corners>> parts;
    for (std::uint32_t t = 0; t < caps.size(); ++t)
        parts[sets.find(t)].push_back(cornersOf(caps[t]));
    std::vector<std::vector<Corners>> result;
    for (auto& [number, triangles] : parts)
        result.push_back(std::move(triangles));
    return result;
}

bool isOfSolids(const PlanePairShadow& shadow, const ShadowCluster& cluster) {
    if (!cluster.closed || cluster.singleSided == 0) return false;
    auto parts =
        manifoldParts(std::span(shadow.caps).subspan(cluster.caps.first, cluster.caps.count));
    return !parts.empty() && std::all_of(parts.begin(), parts.end(), [](auto& triangles) {
        return isOutwards(triangles) && !Halves(std::move(triangles)).anyCross();
    });
}

} // namespace

std::vector<std::uint8_t> findSolids(const PlanePairShadow& shadow) {
    // A pose may cross itself, and the next one comes soon.
    if (shadow.vertices) return std::vector<std::uint8_t>(shadow.clusters.size(), 0);
    std::vector<std::uint8_t> solids;
    for (const ShadowCluster& cluster : shadow.clusters)
        solids.push_back(isOfSolids(shadow, cluster));
    return solids;
}

const std::vector<std::uint8_t>&
KeptSolids::of(const std::shared_ptr<const PlanePairShadow>& shadow) {
    if (shadow->solids) return *shadow->solids;
    const auto found = entries_.find(shadow.get());
    if (found != entries_.end() && found->second.shadow.lock() == shadow)
        return found->second.solids;
    std::erase_if(entries_, [](const auto& entry) { return entry.second.shadow.expired(); });
    return entries_.insert_or_assign(shadow.get(), Entry{shadow, findSolids(*shadow)})
        .first->second.solids;
}

} // namespace edgeshade
