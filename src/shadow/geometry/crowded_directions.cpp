#include "src/shadow/geometry/crowded_directions.hpp"

#include "src/shadow/geometry/flat_casters.hpp"
#include "src/shadow/geometry/touch_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace edgeshade {
namespace {

constexpr int deepest = 12; // halvings of a face's side at most
// Pairs of a triangle and a crowded cell; about a second for 20 million.
constexpr std::size_t leastWork = 20'000'000;
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

    std::array<glm::dvec3, 4> corners() const {
        return {face * glm::dvec3(u0, v0, 1.0), face * glm::dvec3(u1, v0, 1.0),
                face * glm::dvec3(u1, v1, 1.0), face * glm::dvec3(u0, v1, 1.0)};
    }
    /// Planes through the cell's sides and the light, insides positive.
    std::array<glm::dvec3, 4> sides() const {
        return {face * glm::dvec3(1.0, 0.0, -u0), face * glm::dvec3(-1.0, 0.0, u1),
                face * glm::dvec3(0.0, 1.0, -v0), face * glm::dvec3(0.0, -1.0, v1)};
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

/// Whether a convex polygon certainly holds all of a part of its face: dividing the part can't part
/// it from the others that do.
bool covers(std::span<const glm::dvec2> polygon, const Outline& part) {
    const std::array corners{glm::dvec2(part.u0, part.v0), glm::dvec2(part.u1, part.v0),
                             glm::dvec2(part.u1, part.v1), glm::dvec2(part.u0, part.v1)};
    bool left = true, right = true;
    for (std::size_t i = 0; i < polygon.size() && (left || right); ++i) {
        const glm::dvec2 from = polygon[i], along = polygon[(i + 1) % polygon.size()] - from;
        for (const glm::dvec2& corner : corners) {
            const glm::dvec2 to = corner - from;
            const double side = along.x * to.y - along.y * to.x;
            left = left && side > 0.0;
            right = right && side < 0.0;
        }
    }
    return left || right;
}

/// The part of a light's face that triangles reach, and how many do.
struct ReachedPart {
    Outline part;
    std::size_t triangles = 0;

    void add(const Outline& outline) {
        part.u0 = std::min(part.u0, outline.u0);
        part.u1 = std::max(part.u1, outline.u1);
        part.v0 = std::min(part.v0, outline.v0);
        part.v1 = std::max(part.v1, outline.v1);
        ++triangles;
    }
    /// With some room around, but no more than the whole face; empty() where nothing is.
    Outline within(const Outline& whole) const {
        const double room = 1e-9 * (1.0 + std::abs(part.u0) + std::abs(part.u1) +
                                    std::abs(part.v0) + std::abs(part.v1));
        return {std::max(whole.u0, part.u0 - room), std::min(whole.u1, part.u1 + room),
                std::max(whole.v0, part.v0 - room), std::min(whole.v1, part.v1 + room)};
    }
};

/// Counts the triangles that touch the cells of a grid, of finer ones where many do, and divides
/// cells until their members are few enough; keeps the others as `crowded`.
class Divider {
  public:
    Divider(const Scene& scene, bool castMasked, const LightView& from, std::size_t limit)
        : scene_(scene), castMasked_(castMasked), from_(from), casters_(scene, castMasked, from),
          limit_(limit), faces_(from.faces.size()) {}

    void divide() {
        forEachOnFaces([](Face& face, const Member&, std::span<const glm::dvec2> polygon) {
            face.reached.add(outlineOf(polygon));
        });
        for (Face& face : faces_) {
            face.part = face.reached.within(from_.wholeFace());
            if (!face.part.empty()) face.depth = depthFor(face.reached.triangles, 8);
        }
        while (countOnFaces()) {
        }
        forEachOnFaces([](Face& face, const Member& member, std::span<const glm::dvec2> polygon) {
            if (!face.crowded.cells.empty()) face.crowded.add(member, polygon, *face.grid);
        });
        for (std::size_t i = 0; i < faces_.size(); ++i)
            for (const CrowdedCell& cell : faces_[i].crowded.cells)
                refine(from_.faces[i], cell, faces_[i].depth);
    }

    std::size_t most() const { return most_; }
    std::vector<TriangleIndices> crowded() const { return {crowded_.begin(), crowded_.end()}; }

  private:
    static constexpr std::uint32_t isWhole = ~std::uint32_t{0};
    static constexpr int stepDepth = 2;                    ///< of a finer grid
    static constexpr int finestOfAll = 10;                 ///< depth of a grid of a whole face
    static constexpr std::size_t mostPerTriangle = 2;      ///< crowded cells that are looked at
    static constexpr std::size_t mostGathered = 4'000'000; ///< members of them, 8 bytes each

    /// A triangle that may touch a cell: which, and as which of FlatCasters::parts() or isWhole.
    struct Member {
        std::uint32_t triangle, part;
    };
    struct CrowdedCell {
        Outline part;
        std::vector<Member> members{};
    };
    /// The cells of a grid that more than `limit` triangles may touch.
    struct Crowded {
        std::vector<CrowdedCell> cells;
        std::vector<std::int32_t> at; ///< by the grid's rows and columns; -1: it isn't

        void add(const Member& member, std::span<const glm::dvec2> polygon, const TouchGrid& grid) {
            grid.forEachSpan(polygon, [&](int row, int left, int right) {
                const std::int32_t* of = &at[static_cast<std::size_t>(row * grid.side())];
                for (int column = left; column <= right; ++column)
                    if (of[column] >= 0)
                        cells[static_cast<std::size_t>(of[column])].members.push_back(member);
            });
        }
    };
    struct Face {
        ReachedPart reached;
        Outline part;
        int depth = 0; ///< halvings of its sides by the grid; 0: nothing is there
        std::optional<TouchGrid> grid;
        Crowded crowded;
        bool rough = true;    ///< outlines are counted
        bool counted = false; ///< for good
    };

    static int depthFor(std::size_t triangles, int most) {
        int depth = std::min(3, most);
        while (depth < most && (std::size_t{1} << (2 * depth)) < triangles)
            ++depth;
        return depth;
    }

    /// Calls visit(face, member, polygon) for what all faces hold.
    template <class Visit>
    void forEachOnFaces(Visit visit) {
        for (std::uint32_t triangle = 0; triangle < casters_.count(); ++triangle) {
            const int face = casters_.faceOf(triangle);
            if (face < 0) continue;
            const FlatCasters::Corners corners = casters_.cornersOf(triangle);
            visit(faces_[static_cast<std::size_t>(face)], Member{triangle, isWhole},
                  std::span<const glm::dvec2>(corners));
        }
        std::uint32_t part = 0;
        for (const FlatCasters::Part& of : casters_.parts())
            visit(faces_[of.face], Member{of.triangle, part++}, of.polygon.all());
    }

    /// Counts on faces that aren't counted yet. Some may ask for a finer grid, as it takes less to
    /// count all in one than to look at so many crowded cells one by one: true.
    bool countOnFaces() {
        for (Face& face : faces_)
            if (!face.counted && face.depth > 0) face.grid.emplace(face.part, face.depth);
        forEachOnFaces([](Face& face, const Member&, std::span<const glm::dvec2> polygon) {
            if (face.counted || !face.grid) return;
            if (face.rough)
                face.grid->add(outlineOf(polygon));
            else
                face.grid->add(polygon);
        });
        bool again = false;
        for (Face& face : faces_) {
            if (face.counted || !face.grid) continue;
            face.grid->sum();
            const bool finer =
                face.depth < finestOfAll &&
                membersOfCrowded(*face.grid) > mostPerTriangle * face.reached.triangles;
            if (finer && !face.rough) face.depth = std::min(face.depth + 2, finestOfAll);
            face.rough = false;
            face.counted = !finer;
            if (face.counted) findCrowded(face);
            again = again || finer;
        }
        return again;
    }

    void findCrowded(Face& face) {
        if (membersOfCrowded(*face.grid) <= mostGathered + 2 * mostPerTriangle * casters_.count()) {
            face.crowded = crowdedOf(*face.grid);
            return;
        }
        // All of the face is looked at as one cell, which parts where it pays.
        face.depth = 0;
        face.grid.emplace(face.part, 0);
        face.crowded = {{{face.part}}, {0}};
    }

    std::size_t membersOfCrowded(const TouchGrid& grid) const {
        std::size_t members = 0;
        for (int row = 0; row < grid.side(); ++row)
            for (int column = 0; column < grid.side(); ++column)
                if (grid.count(row, column) > limit_) members += grid.count(row, column);
        return members;
    }

    /// Of a grid that is summed.
    Crowded crowdedOf(const TouchGrid& grid) {
        Crowded crowded;
        for (int row = 0; row < grid.side(); ++row)
            for (int column = 0; column < grid.side(); ++column) {
                const std::size_t count = grid.count(row, column);
                if (count <= limit_) {
                    most_ = std::max(most_, count);
                    continue;
                }
                if (crowded.at.empty())
                    crowded.at.assign(static_cast<std::size_t>(grid.side() * grid.side()), -1);
                crowded.at[static_cast<std::size_t>(row * grid.side() + column)] =
                    static_cast<std::int32_t>(crowded.cells.size());
                crowded.cells.push_back({grid.cell(row, column)});
                crowded.cells.back().members.reserve(count);
            }
        return crowded;
    }

    /// Calls visit(member, polygon).
    template <class Visit>
    void forEachPolygon(const std::vector<Member>& members, Visit visit) const {
        for (const Member& member : members) {
            if (member.part == isWhole)
                visit(member, std::span<const glm::dvec2>(casters_.cornersOf(member.triangle)));
            else
                visit(member, casters_.parts()[member.part].polygon.all());
        }
    }

    /// Counts in a finer grid while that may part members, and else looks closely.
    void refine(const glm::dmat3& face, const CrowdedCell& cell, int depth) {
        work_ += cell.members.size();
        const std::size_t mostWork = std::max(leastWork, workPerTriangle * casters_.count());
        if (depth == deepest || work_ > mostWork || isCovered(cell))
            return lookClosely({face, cell.part}, cell.members);
        const int finer = std::min(stepDepth, deepest - depth);
        TouchGrid grid(cell.part, finer);
        forEachPolygon(cell.members, [&](const Member&, std::span<const glm::dvec2> polygon) {
            grid.add(polygon);
        });
        grid.sum();
        Crowded crowded = crowdedOf(grid);
        if (crowded.cells.empty()) return;
        forEachPolygon(cell.members,
                       [&](const Member& member, std::span<const glm::dvec2> polygon) {
                           crowded.add(member, polygon, grid);
                       });
        for (const CrowdedCell& one : crowded.cells)
            refine(face, one, depth + finer);
    }

    /// Whether more than `limit` members hold all of it.
    bool isCovered(const CrowdedCell& cell) const {
        std::size_t covering = 0;
        forEachPolygon(cell.members, [&](const Member&, std::span<const glm::dvec2> polygon) {
            covering += covers(polygon, cell.part);
        });
        return covering > limit_;
    }

    void lookClosely(const Cell& cell, const std::vector<Member>& members) {
        const auto corners = cell.corners();
        const auto sides = cell.sides();
        TriangleIndices touching;
        for (const Member& member : members)
            if (mayTouch(TriangleCone(rays()[member.triangle]), corners, sides))
                touching.push_back(member.triangle);
        most_ = std::max(most_, touching.size());
        if (touching.size() > limit_) crowded_.insert(std::move(touching));
    }

    /// To the corners of all casters, made when the grid is too coarse somewhere.
    const std::vector<std::array<glm::dvec3, 3>>& rays() {
        if (!rays_.empty()) return rays_;
        rays_.reserve(casters_.count());
        forEachCaster(scene_, castMasked_, from_,
                      [&](const std::array<glm::dvec3, 3>& corners) { rays_.push_back(corners); });
        return rays_;
    }

    const Scene& scene_;
    const bool castMasked_;
    const LightView& from_;
    FlatCasters casters_;
    const std::size_t limit_;
    std::vector<Face> faces_;
    std::vector<std::array<glm::dvec3, 3>> rays_;
    std::size_t most_ = 0;
    std::size_t work_ = 0;              ///< pairs of a triangle and a crowded cell
    std::set<TriangleIndices> crowded_; ///< many neighbours have the same
};

} // namespace

CrowdedDirections crowdedDirections(const Scene& scene, bool castMasked, const Light& light,
                                    std::size_t limit) {
    const LightView from(light);
    Divider divider(scene, castMasked, from, limit);
    divider.divide();
    return {divider.most(), divider.crowded()};
}

} // namespace edgeshade
