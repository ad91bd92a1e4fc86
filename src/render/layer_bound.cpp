#include "src/render/layer_bound.hpp"

#include "preprocess/topology.hpp"
#include "src/render/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace edgeshade {
namespace {

constexpr int gridDepth = 9; // halvings of a face's side counted at once
constexpr int deepest = 12;  // halvings at most
// Pairs of a triangle and a cell that are looked at closely; about a second for 50 million.
constexpr std::size_t leastWork = 50'000'000;
constexpr std::size_t workPerTriangle = 40;
constexpr double rounding = 1e-12;

/// A convex cone of three rays, as seen from the light; for a sun, points (x, y, 1) of the plane
/// across its direction. `sides` are the planes between neighbouring rays, insides positive.
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
        return {{{face, u0, u, v0, v},
                 {face, u, u1, v0, v},
                 {face, u0, u, v, v1},
                 {face, u, u1, v, v1}}};
    }
};

/// Where a triangle may lie on a face, in the face's u and v; low above high: nowhere.
struct Outline {
    double u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;

    /// Takes in a ray in the face's axes, in front of the light.
    void add(const glm::dvec3& on) {
        const double u = on.x / on.z, v = on.y / on.z;
        const double reach = outlineMargin * (1.0 + std::abs(u) + std::abs(v));
        u0 = std::min(u0, u - reach);
        u1 = std::max(u1, u + reach);
        v0 = std::min(v0, v - reach);
        v1 = std::max(v1, v + reach);
    }
    bool misses(const Cell& cell) const {
        return u1 < cell.u0 || u0 > cell.u1 || v1 < cell.v0 || v0 > cell.v1;
    }

  private:
    static constexpr double outlineMargin = 1e-9; // against rounding
};

Outline outlineOn(const glm::dmat3& face, const TriangleCone& triangle) {
    Polygon polygon;
    std::size_t behind = 0, near = 0;
    for (const glm::dvec3& ray : triangle.rays) {
        const glm::dvec3 on = ray * face;
        polygon.add(on);
        const double across = std::max(std::abs(on.x), std::abs(on.y));
        behind += on.z < -1e-9 * across;
        near += on.z <= 1e-3 * across;
    }
    Outline outline;
    if (behind == 3) return outline;
    if (near > 0) {
        // A little wider than the face, so that rounding loses nothing.
        for (const glm::dvec3& plane : {glm::dvec3(1.0, 0.0, 1.001), glm::dvec3(-1.0, 0.0, 1.001),
                                        glm::dvec3(0.0, 1.0, 1.001), glm::dvec3(0.0, -1.0, 1.001)})
            polygon = clipped(polygon, plane);
    }
    for (std::size_t c = 0; c < polygon.count; ++c) {
        const glm::dvec3& corner = polygon.corners[c];
        if (!(corner.z > 0.0)) return {-INFINITY, INFINITY, -INFINITY, INFINITY}; // at the light
        outline.add(corner);
    }
    return outline;
}

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

std::vector<TriangleCone> conesFrom(const Scene& scene, bool castMasked, const Light& light) {
    const glm::dvec3 position(light.position);
    const bool sun = light.position.w == 0.0;
    glm::dvec3 across(0.0), upward(0.0);
    if (sun) {
        const glm::dvec3 towards = glm::normalize(position);
        across = glm::normalize(glm::cross(
            towards, std::abs(towards.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        upward = glm::cross(towards, across);
    }
    std::vector<TriangleCone> cones;
    for (const Batch& batch : scene.batches) {
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        for (std::size_t i = 0; i < casters.indices.size(); i += 3) {
            std::array<glm::dvec3, 3> rays;
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::dvec3 world(batch.worldFromBatch *
                                       glm::dvec4(batch.positions[casters.indices[i + c]], 1.0));
                rays[c] = sun ? glm::dvec3(glm::dot(across, world), glm::dot(upward, world), 1.0)
                              : world - position;
            }
            cones.emplace_back(rays);
        }
    }
    return cones;
}

/// The cells to begin with: six faces of a cube, or the outline of the scene across a sun.
std::vector<Cell> firstCells(const std::vector<TriangleCone>& cones, bool sun) {
    if (sun) {
        double u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;
        for (const TriangleCone& cone : cones)
            for (const glm::dvec3& ray : cone.rays) {
                u0 = std::min(u0, ray.x);
                u1 = std::max(u1, ray.x);
                v0 = std::min(v0, ray.y);
                v1 = std::max(v1, ray.y);
            }
        return {{glm::dmat3(1.0), u0, u1, v0, v1}};
    }
    std::vector<Cell> cells;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            glm::dmat3 face(0.0);
            face[0][(axis + 1) % 3] = 1.0;
            face[1][(axis + 2) % 3] = 1.0;
            face[2][axis] = sign;
            cells.push_back({face, -1.0, 1.0, -1.0, 1.0});
        }
    return cells;
}

using Members = std::vector<std::uint32_t>; ///< indices of cones

/// A face in equal cells, and how many outlines may touch each.
class OutlineGrid {
  public:
    static constexpr int side = 1 << gridDepth;

    OutlineGrid(const Cell& face, const std::vector<Outline>& outlines)
        : face_(face), counts_((side + 1) * (side + 1), 0) {
        // Each outline adds to its four corners; the sums from the first corner are the counts.
        for (const Outline& outline : outlines) {
            const auto range = rangeOf(outline);
            if (!range) continue;
            at(range->i0, range->j0) += 1;
            at(range->i1 + 1, range->j0) -= 1;
            at(range->i0, range->j1 + 1) -= 1;
            at(range->i1 + 1, range->j1 + 1) += 1;
        }
        for (int j = 0; j <= side; ++j)
            for (int i = 1; i <= side; ++i)
                at(i, j) += at(i - 1, j);
        for (int j = 1; j <= side; ++j)
            for (int i = 0; i <= side; ++i)
                at(i, j) += at(i, j - 1);
    }

    struct Range {
        int i0, i1, j0, j1; ///< cells, last ones included
    };

    /// The cells that an outline may touch; nothing if it misses the face.
    std::optional<Range> rangeOf(const Outline& outline) const {
        if (outline.misses(face_)) return std::nullopt;
        return Range{column(outline.u0), column(outline.u1), row(outline.v0), row(outline.v1)};
    }

    std::size_t count(int i, int j) const {
        return static_cast<std::size_t>(counts_[static_cast<std::size_t>(j) * (side + 1) + i]);
    }

    Cell cell(int i, int j) const {
        return {face_.face, face_.u0 + (face_.u1 - face_.u0) * i / side,
                face_.u0 + (face_.u1 - face_.u0) * (i + 1) / side,
                face_.v0 + (face_.v1 - face_.v0) * j / side,
                face_.v0 + (face_.v1 - face_.v0) * (j + 1) / side};
    }

  private:
    int& at(int i, int j) { return counts_[static_cast<std::size_t>(j) * (side + 1) + i]; }
    int column(double u) const { return place((u - face_.u0) / (face_.u1 - face_.u0)); }
    int row(double v) const { return place((v - face_.v0) / (face_.v1 - face_.v0)); }
    static int place(double share) {
        return static_cast<int>(std::clamp(share * side, 0.0, side - 1.0));
    }

    Cell face_;
    std::vector<int> counts_;
};

/// The part of a face that outlines reach.
Cell reachedPart(const Cell& face, const std::vector<Outline>& outlines) {
    Outline all{INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (const Outline& outline : outlines) {
        if (outline.misses(face)) continue;
        all.u0 = std::min(all.u0, outline.u0);
        all.u1 = std::max(all.u1, outline.u1);
        all.v0 = std::min(all.v0, outline.v0);
        all.v1 = std::max(all.v1, outline.v1);
    }
    return {face.face, std::max(face.u0, all.u0), std::min(face.u1, all.u1),
            std::max(face.v0, all.v0), std::min(face.v1, all.v1)};
}

/// Divides faces until cells' members are few enough; keeps the others as `crowded`.
class Divider {
  public:
    Divider(const std::vector<TriangleCone>& cones, std::size_t limit)
        : cones_(cones), limit_(limit),
          mostWork_(std::max(leastWork, workPerTriangle * cones.size())) {}

    /// Counts outlines in a grid at once, then looks closely where they are many.
    void divideFace(const Cell& whole) {
        outlines_.clear();
        outlines_.reserve(cones_.size());
        for (const TriangleCone& cone : cones_)
            outlines_.push_back(outlineOn(whole.face, cone));
        const Cell face = reachedPart(whole, outlines_);
        if (!(face.u0 < face.u1) || !(face.v0 < face.v1)) return divideWhole(whole);

        const OutlineGrid grid(face, outlines_);
        std::map<std::pair<int, int>, Members> many; // by row and column
        std::size_t mostOfFew = 0;
        for (int j = 0; j < OutlineGrid::side; ++j)
            for (int i = 0; i < OutlineGrid::side; ++i) {
                if (grid.count(i, j) <= limit_)
                    mostOfFew = std::max(mostOfFew, grid.count(i, j));
                else if (many.size() == mostCellsApart)
                    return divideWhole(face);
                else
                    many[{j, i}];
            }
        most_ = std::max(most_, mostOfFew);
        for (std::uint32_t t = 0; t < outlines_.size() && !many.empty(); ++t) {
            const auto range = grid.rangeOf(outlines_[t]);
            if (!range) continue;
            auto cell = many.lower_bound({range->j0, range->i0});
            for (; cell != many.end() && cell->first.first <= range->j1; ++cell)
                if (cell->first.second >= range->i0 && cell->first.second <= range->i1)
                    cell->second.push_back(t);
        }
        for (const auto& [place, members] : many)
            divide(grid.cell(place.second, place.first), members, gridDepth);
    }

    std::size_t most() const { return most_; }
    const std::vector<Members>& crowded() const { return crowded_; }

  private:
    static constexpr std::size_t mostCellsApart = 256;

    void divideWhole(const Cell& face) {
        Members all(cones_.size());
        std::iota(all.begin(), all.end(), 0u);
        divide(face, all, 0);
    }

    void divide(const Cell& cell, const Members& parents, int depth) {
        const auto corners = cell.corners();
        const auto sides = cell.sides();
        Members members;
        std::size_t covering = 0;
        for (const std::uint32_t i : parents) {
            if (outlines_[i].misses(cell)) continue;
            ++work_;
            if (!mayTouch(cones_[i], corners, sides)) continue;
            members.push_back(i);
            covering += covers(cones_[i], corners);
        }
        const bool hopeless = covering > limit_ || depth == deepest || work_ > mostWork_;
        if (members.size() <= limit_ || hopeless) {
            most_ = std::max(most_, members.size());
            if (members.size() > limit_) crowded_.push_back(std::move(members));
            return;
        }
        for (const Cell& quarter : cell.quarters())
            divide(quarter, members, depth + 1);
    }

    const std::vector<TriangleCone>& cones_;
    const std::size_t limit_;
    const std::size_t mostWork_;
    std::vector<Outline> outlines_; ///< of all cones on the face that is being divided
    std::size_t most_ = 0;
    std::size_t work_ = 0; ///< pairs of a triangle and a cell looked at closely
    std::vector<Members> crowded_;
};

/// Groups such that no crowded cell has more than `limit` members of one; triangles outside
/// crowded cells are in group 0.
void assignGroups(const std::vector<Members>& crowded, std::size_t triangles, std::size_t limit,
                  LayerBound& bound) {
    std::vector<Members> cellsOf(triangles);
    for (std::uint32_t cell = 0; cell < crowded.size(); ++cell)
        for (const std::uint32_t triangle : crowded[cell])
            cellsOf[triangle].push_back(cell);

    bound.groupOf.assign(triangles, 0);
    std::vector<std::vector<std::size_t>> taken; // by group, by cell
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
        if (cellsOf[triangle].empty()) continue;
        const auto fits = [&](const std::vector<std::size_t>& counts) {
            return std::all_of(cellsOf[triangle].begin(), cellsOf[triangle].end(),
                               [&](std::uint32_t cell) { return counts[cell] < limit; });
        };
        auto group = std::find_if(taken.begin(), taken.end(), fits);
        if (group == taken.end())
            group = taken.insert(taken.end(), std::vector<std::size_t>(crowded.size(), 0));
        for (const std::uint32_t cell : cellsOf[triangle])
            ++(*group)[cell];
        bound.groupOf[triangle] = static_cast<std::uint32_t>(group - taken.begin());
    }
    bound.groupCount = std::max<std::size_t>(1, taken.size());
}

} // namespace

LayerBound boundLayers(const Scene& scene, bool castMasked, const Light& light, std::size_t limit) {
    LayerBound bound;
    bound.most = scene.triangleCount();
    if (bound.most <= limit) return bound;

    const std::vector<TriangleCone> cones = conesFrom(scene, castMasked, light);
    Divider divider(cones, limit);
    for (const Cell& cell : firstCells(cones, light.position.w == 0.0))
        divider.divideFace(cell);
    bound.most = divider.most();
    if (bound.most > limit) assignGroups(divider.crowded(), cones.size(), limit, bound);
    return bound;
}

} // namespace edgeshade
