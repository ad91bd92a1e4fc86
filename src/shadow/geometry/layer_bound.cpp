#include "src/shadow/geometry/layer_bound.hpp"

#include "src/shadow/geometry/face_outlines.hpp"
#include "src/shadow/geometry/outline_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace edgeshade {
namespace {

constexpr int deepest = 12; // halvings of a face's side at most
// Pairs of a triangle and a cell that are looked at closely; about a second for 50 million.
constexpr std::size_t leastWork = 50'000'000;
constexpr std::size_t workPerTriangle = 40;
constexpr double rounding = 1e-12;

/// A convex cone of three rays, as seen from the light; for a directional light, points (x, y, 1)
/// of the plane across its direction. `sides` are the planes between neighbouring rays, insides
/// positive.
struct TriangleCone {
    std::array<glm::dvec3, 3> rays;
    std::array<glm::dvec3, 3> sides;

    explicit TriangleCone(const std::array<glm::dvec3, 3>& corners) : rays(corners) {
        for (std::size_t i = 0; i < 3; ++i) {
            sides[i] = glm::cross(rays[i], rays[(i + 1) % 3]);
            if (glm::dot(sides[i], rays[(i + 2) % 3]) < 0.0) sides[i] = -sides[i];
        }
    }
};

/// A cell of directions: a rectangle on a face of a cube around the light.
struct Cell {
    glm::dmat3 face; ///< columns: u axis, v axis, outward axis
    double u0, u1, v0, v1;

    Cell(const glm::dmat3& onFace, const Outline& part)
        : face(onFace), u0(part.u0), u1(part.u1), v0(part.v0), v1(part.v1) {}
    Outline part() const { return {u0, u1, v0, v1}; }

    std::array<glm::dvec3, 4> corners() const {
        return {face * glm::dvec3(u0, v0, 1.0), face * glm::dvec3(u1, v0, 1.0),
                face * glm::dvec3(u1, v1, 1.0), face * glm::dvec3(u0, v1, 1.0)};
    }
    /// Planes through the cell's sides and the light, insides positive.
    std::array<glm::dvec3, 4> sides() const {
        return {face * glm::dvec3(1.0, 0.0, -u0), face * glm::dvec3(-1.0, 0.0, u1),
                face * glm::dvec3(0.0, 1.0, -v0), face * glm::dvec3(0.0, -1.0, v1)};
    }
    std::array<Cell, 4> quarters() const {
        const double u = 0.5 * (u0 + u1), v = 0.5 * (v0 + v1);
        return {{{face, {u0, u, v0, v}},
                 {face, {u, u1, v0, v}},
                 {face, {u0, u, v, v1}},
                 {face, {u, u1, v, v1}}}};
    }
};

double magnitude(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Whether all vectors lie outside the plane, rounding allowed for.
template <std::size_t N>
bool allOutside(const glm::dvec3& plane, const std::array<glm::dvec3, N>& vectors) {
    for (const glm::dvec3& vector : vectors)
        if (glm::dot(plane, vector) >= -rounding * magnitude(plane) * magnitude(vector))
            return false;
    return true;
}

/// Whether the cones may have a direction in common: no side of either separates them.
bool mayTouch(const TriangleCone& triangle, const std::array<glm::dvec3, 4>& corners,
              const std::array<glm::dvec3, 4>& sides) {
    for (const glm::dvec3& side : sides)
        if (allOutside(side, triangle.rays)) return false;
    for (const glm::dvec3& side : triangle.sides)
        if (allOutside(side, corners)) return false;
    return true;
}

/// Whether the triangle's cone holds the whole cell: dividing the cell can't part them.
bool covers(const TriangleCone& triangle, const std::array<glm::dvec3, 4>& corners) {
    for (const glm::dvec3& side : triangle.sides)
        for (const glm::dvec3& corner : corners)
            if (glm::dot(side, corner) < 0.0) return false;
    return true;
}

using Members = std::vector<std::uint32_t>; ///< indices of triangles, or of a face's outlines

/// Divides faces until cells' members are few enough; keeps the others as `crowded`.
class Divider {
  public:
    Divider(const Scene& scene, bool castMasked, const LightView& from, std::size_t limit)
        : scene_(scene), castMasked_(castMasked), from_(from), limit_(limit) {}

    /// Counts outlines in a grid at once, then looks closely where they are many.
    void divideFace(const glm::dmat3& face, const FaceOutlines& here) {
        here_ = &here;
        const std::vector<Outline>& outlines = here.outlines;
        const Outline reached = reachedPart(from_.wholeFace(), outlines);
        if (reached.empty()) return; // nothing is there

        const OutlineGrid grid(reached, outlines);
        std::map<std::pair<int, int>, Members> many; // by row and column
        std::size_t mostOfFew = 0;
        for (int j = 0; j < OutlineGrid::side; ++j)
            for (int i = 0; i < OutlineGrid::side; ++i) {
                if (grid.count(i, j) <= limit_)
                    mostOfFew = std::max(mostOfFew, grid.count(i, j));
                else if (many.size() == mostCellsApart)
                    return divideWhole({face, reached});
                else
                    many[{j, i}];
            }
        most_ = std::max(most_, mostOfFew);
        for (std::uint32_t t = 0; t < outlines.size() && !many.empty(); ++t) {
            const auto range = grid.rangeOf(outlines[t]);
            if (!range) continue;
            auto cell = many.lower_bound({range->j0, range->i0});
            for (; cell != many.end() && cell->first.first <= range->j1; ++cell)
                if (cell->first.second >= range->i0 && cell->first.second <= range->i1)
                    cell->second.push_back(t);
        }
        for (const auto& [place, members] : many)
            divide({face, grid.cell(place.second, place.first)}, members, OutlineGrid::depth);
    }

    std::size_t most() const { return most_; }
    const std::vector<Members>& crowded() const { return crowded_; }

  private:
    static constexpr std::size_t mostCellsApart = 256;

    void divideWhole(const Cell& face) {
        Members all(here_->outlines.size());
        std::iota(all.begin(), all.end(), 0u);
        divide(face, all, 0);
    }

    void divide(const Cell& cell, const Members& parents, int depth) {
        const auto corners = cell.corners();
        const auto sides = cell.sides();
        Members members;
        std::size_t covering = 0;
        for (const std::uint32_t i : parents) {
            if (here_->outlines[i].misses(cell.part())) continue;
            ++work_;
            const TriangleCone cone(rays()[here_->triangles[i]]);
            if (!mayTouch(cone, corners, sides)) continue;
            members.push_back(i);
            covering += covers(cone, corners);
        }
        const std::size_t mostWork = std::max(leastWork, workPerTriangle * rays().size());
        const bool hopeless = covering > limit_ || depth == deepest || work_ > mostWork;
        if (members.size() <= limit_ || hopeless) {
            most_ = std::max(most_, members.size());
            if (members.size() <= limit_) return;
            for (std::uint32_t& member : members)
                member = here_->triangles[member];
            crowded_.push_back(std::move(members));
            return;
        }
        for (const Cell& quarter : cell.quarters())
            divide(quarter, members, depth + 1);
    }

    /// To the corners of all casters, made when the grid is too coarse somewhere.
    const std::vector<std::array<glm::dvec3, 3>>& rays() {
        if (!rays_.empty()) return rays_;
        rays_.reserve(scene_.triangleCount());
        forEachCaster(scene_, castMasked_, from_,
                      [&](const std::array<glm::dvec3, 3>& corners) { rays_.push_back(corners); });
        return rays_;
    }

    const Scene& scene_;
    const bool castMasked_;
    const LightView& from_;
    const std::size_t limit_;
    std::vector<std::array<glm::dvec3, 3>> rays_;
    const FaceOutlines* here_ = nullptr; ///< of the face that is being divided
    std::size_t most_ = 0;
    std::size_t work_ = 0; ///< pairs of a triangle and a cell looked at closely
    std::vector<Members> crowded_;
};

/// What comes into one group together: a triangle, or all of a place of a mesh that is kept once.
struct Units {
    std::vector<std::uint32_t> of; ///< by triangle, ascending
    std::size_t count = 0;

    void add(std::size_t triangles, bool together) {
        for (std::size_t t = 0; t < triangles; ++t)
            of.push_back(static_cast<std::uint32_t>(together ? count : count + t));
        count += together ? 1 : triangles;
    }
};

/// How many of a cell's members each unit has.
std::map<std::uint32_t, std::size_t> membersByUnit(const Members& cell, const Units& units) {
    std::map<std::uint32_t, std::size_t> members;
    for (const std::uint32_t triangle : cell)
        ++members[units.of[triangle]];
    return members;
}

/// Places whose triangles alone crowd a cell come triangle by triangle.
Units unitsOf(const Scene& scene, bool castMasked, const std::vector<Members>& crowded,
              std::size_t limit) {
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    std::vector<std::size_t> places(first.size(), 0), triangles(first.size(), 0);
    Units whole;
    std::vector<std::uint32_t> unitOfBatch;
    for (std::size_t i = 0; i < first.size(); ++i)
        ++places[first[i]];
    for (std::size_t i = 0; i < first.size(); ++i) {
        triangles[i] =
            first[i] != i
                ? triangles[first[i]]
                : castersOf(scene.batches[i], scene.materials, castMasked).indices.size() / 3;
        unitOfBatch.push_back(static_cast<std::uint32_t>(whole.count));
        whole.add(triangles[i], places[first[i]] > 1);
    }
    std::vector<bool> tooMany(whole.count, false);
    for (const Members& cell : crowded)
        for (const auto& [unit, count] : membersByUnit(cell, whole))
            if (count > limit) tooMany[unit] = true;
    if (std::find(tooMany.begin(), tooMany.end(), true) == tooMany.end()) return whole;
    Units units;
    for (std::size_t i = 0; i < first.size(); ++i)
        units.add(triangles[i],
                  places[first[i]] > 1 && triangles[i] > 0 && !tooMany[unitOfBatch[i]]);
    return units;
}

/// Groups such that no crowded cell has more than `limit` members of one; units outside crowded
/// cells are in group 0. None where it takes more than mostGroups.
void assignGroups(const std::vector<Members>& crowded, const Units& units, std::size_t limit,
                  LayerBound& bound) {
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

LayerBound boundLayers(const Scene& scene, bool castMasked, std::span<const Light> lights,
                       std::size_t limit) {
    LayerBound bound;
    bound.most = scene.triangleCount();
    if (bound.most <= limit) return bound;

    bound.most = 0;
    std::vector<Members> crowded;
    for (const Light& light : lights) {
        const LightView from(light);
        const std::vector<FaceOutlines> byFace = outlinesByFace(scene, castMasked, from);
        Divider divider(scene, castMasked, from, limit);
        for (std::size_t i = 0; i < byFace.size(); ++i)
            divider.divideFace(from.faces[i], byFace[i]);
        bound.most = std::max(bound.most, divider.most());
        crowded.insert(crowded.end(), divider.crowded().begin(), divider.crowded().end());
    }
    if (bound.most > limit)
        assignGroups(crowded, unitsOf(scene, castMasked, crowded, limit), limit, bound);
    return bound;
}

} // namespace edgeshade
