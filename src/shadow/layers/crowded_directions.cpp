#include "src/shadow/layers/crowded_directions.hpp"

#include "preprocess/base/parallel.hpp"
#include "src/shadow/layers/closer_look.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeshade {
namespace {

// Limit of pairs of a triangle and a crowded cell; 20 million take about a second.
constexpr std::size_t leastSearchWork = 20'000'000;
constexpr std::size_t workPerTriangle = 40;

/// Each thread has its own grids: with more threads, adding the grids would take longer than
/// counting.
constexpr std::size_t mostThreads = 4;

/// The part of a light's face that triangles reach, and their number.
struct ReachedPart {
    Outline part;
    std::size_t triangles = 0;

    void add(const Outline& outline) {
        part.add(outline);
        ++triangles;
    }
    void add(const ReachedPart& other) {
        part.add(other.part);
        triangles += other.triangles;
    }
    /// The part with a small margin, within the whole face; empty() if no triangle reaches it.
    Outline within(const Outline& whole) const {
        const double room = 1e-9 * (1.0 + std::abs(part.u0) + std::abs(part.u1) +
                                    std::abs(part.v0) + std::abs(part.v1));
        return {std::max(whole.u0, part.u0 - room), std::min(whole.u1, part.u1 + room),
                std::max(whole.v0, part.v0 - room), std::min(whole.v1, part.v1 + room)};
    }
};

/// Counts the triangles on a light's faces in grids.
class FaceCounts {
  public:
    FaceCounts(const FlatCasters& casters, const LightView& from, std::size_t limit)
        : casters_(casters), limit_(limit), faces_(from.faces.size()) {
        findParts(from);
        while (count()) {
        }
        if (std::all_of(faces_.begin(), faces_.end(),
                        [](const Face& face) { return face.crowded.empty(); }))
            return;
        forEach({0, casters.count()}, [&](std::size_t face, const CellMember& member,
                                          std::span<const glm::dvec2> polygon) {
            Face& of = faces_[face];
            if (!of.crowded.empty()) of.crowded.add(member, polygon, *of.grid);
        });
    }

    struct Face {
        ReachedPart reached{};
        Outline part{};
        int depth = 0;        ///< halvings of its sides by the grid; 0: no triangles
        bool rough = true;    ///< counts the triangles' outlines
        bool counted = false; ///< counted, and final
        std::optional<TouchGrid> grid{};
        CrowdedCells crowded{};
    };
    const std::vector<Face>& faces() const { return faces_; }
    /// The most triangles in cells that aren't crowded.
    std::size_t most() const { return most_; }

  private:
    static constexpr int coarsest = 3, finest = 10;        ///< depths of grids
    static constexpr int mostAtFirst = 8;                  ///< deepest first grid
    static constexpr std::size_t mostPerTriangle = 2;      ///< crowded cells examined
    static constexpr std::size_t mostGathered = 4'000'000; ///< members of crowded cells, 8 bytes
                                                           ///< each

    std::vector<ItemRange> parts() const {
        return partsOf(casters_.count(), itemsOfThread,
                       {std::min(Threads::available(), mostThreads)});
    }

    /// Calls visit(face, member, polygon) for those triangles. The range with the first triangle
    /// also visits all parts of triangles that no face holds wholly.
    template <class Visit>
    void forEach(const ItemRange& triangles, Visit visit) const {
        for (std::size_t t = triangles.first; t < triangles.end; ++t) {
            const CellMember member{static_cast<std::uint32_t>(t), CellMember::isWhole};
            const int face = casters_.faceOf(member.triangle);
            if (face < 0) continue;
            const FlatCasters::Corners corners = casters_.cornersOf(member.triangle);
            visit(static_cast<std::size_t>(face), member, std::span<const glm::dvec2>(corners));
        }
        if (triangles.first > 0) return;
        std::uint32_t part = 0;
        for (const FlatCasters::Part& of : casters_.parts())
            visit(of.face, CellMember{of.triangle, part++}, of.polygon.all());
    }

    void findParts(const LightView& from) {
        const std::vector<ItemRange> ranges = parts();
        std::vector<std::vector<ReachedPart>> reached(ranges.size());
        forEachPart(ranges, [&](std::size_t i, const ItemRange& range) {
            reached[i].resize(faces_.size());
            forEach(range,
                    [&](std::size_t face, const CellMember&, std::span<const glm::dvec2> polygon) {
                        reached[i][face].add(outlineOf(polygon));
                    });
        });
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            Face& face = faces_[f];
            for (const std::vector<ReachedPart>& by : reached)
                face.reached.add(by[f]);
            face.part = face.reached.within(from.wholeFace());
            if (!face.part.empty()) face.depth = depthFor(face.reached.triangles);
        }
    }

    static int depthFor(std::size_t triangles) {
        int depth = coarsest;
        while (depth < mostAtFirst && (std::size_t{1} << (2 * depth)) < triangles)
            ++depth;
        return depth;
    }

    /// Counts on faces that aren't final. Returns whether some need a finer grid: counting
    /// everything in one is faster than examining so many crowded cells one by one.
    bool count() {
        const std::vector<ItemRange> ranges = parts();
        std::vector<std::vector<std::optional<TouchGrid>>> grids(ranges.size());
        forEachPart(ranges, [&](std::size_t i, const ItemRange& range) {
            for (const Face& face : faces_) {
                grids[i].emplace_back();
                if (!face.counted && face.depth > 0) grids[i].back().emplace(face.part, face.depth);
            }
            forEach(range,
                    [&](std::size_t face, const CellMember&, std::span<const glm::dvec2> polygon) {
                        std::optional<TouchGrid>& grid = grids[i][face];
                        if (!grid) return;
                        if (faces_[face].rough)
                            grid->add(outlineOf(polygon));
                        else
                            grid->add(polygon);
                    });
        });
        bool again = false;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            Face& face = faces_[f];
            if (face.counted || face.depth == 0) continue;
            face.grid = std::move(grids[0][f]);
            for (std::size_t i = 1; i < grids.size(); ++i)
                face.grid->add(*grids[i][f]);
            face.grid->sum();
            again = !judge(face) || again;
        }
        return again;
    }

    /// Whether to keep this grid.
    bool judge(Face& face) {
        const std::size_t members = membersOfCrowded(*face.grid);
        const bool finer =
            face.depth < finest && members > mostPerTriangle * face.reached.triangles;
        if (finer && !face.rough) face.depth = std::min(face.depth + 2, finest);
        face.rough = false;
        face.counted = !finer;
        if (finer) return false;
        if (members <= mostGathered + 2 * mostPerTriangle * casters_.count()) {
            face.crowded = CrowdedCells(*face.grid, limit_, most_);
            return true;
        }
        // Examines the whole face as one cell, which is divided where that pays.
        face.depth = 0;
        face.grid.emplace(face.part, 0);
        face.crowded = CrowdedCells::ofAll(face.part);
        return true;
    }

    std::size_t membersOfCrowded(const TouchGrid& grid) const {
        std::size_t members = 0;
        for (int row = 0; row < grid.side(); ++row)
            for (int column = 0; column < grid.side(); ++column)
                if (grid.count(row, column) > limit_) members += grid.count(row, column);
        return members;
    }

    const FlatCasters& casters_;
    const std::size_t limit_;
    std::vector<Face> faces_;
    std::size_t most_ = 0;
};

} // namespace

CrowdedDirections crowdedDirections(const Scene& scene, bool castMasked, const Light& light,
                                    std::size_t limit) {
    const LightView from(light);
    const FlatCasters casters(scene, castMasked, from);
    const FaceCounts counts(casters, from, limit);

    struct Place {
        const CrowdedCell* cell;
        std::size_t face;
    };
    std::vector<Place> places;
    std::size_t members = 0;
    for (std::size_t face = 0; face < counts.faces().size(); ++face)
        for (const CrowdedCell& cell : counts.faces()[face].crowded.all()) {
            places.push_back({&cell, face});
            members += cell.members.size();
        }
    // Each cell's work limit is in proportion to its members, independent of the thread.
    const std::size_t mostWork = std::max(leastSearchWork, workPerTriangle * casters.count());
    const double workPerMember =
        static_cast<double>(mostWork) / static_cast<double>(std::max<std::size_t>(members, 1));
    const std::vector<ItemRange> ranges = partsOf(places.size(), 16, Threads());
    std::vector<CloserLook> looks(ranges.size(), CloserLook(casters, limit));
    forEachPart(ranges, [&](std::size_t i, const ItemRange& range) {
        for (std::size_t p = range.first; p < range.end; ++p) {
            const auto& [cell, face] = places[p];
            looks[i].at(from.faces[face], *cell, counts.faces()[face].depth,
                        static_cast<std::size_t>(workPerMember *
                                                 static_cast<double>(cell->members.size())));
        }
    });

    CrowdedDirections result;
    result.most = counts.most();
    std::set<TriangleIndices> crowded;
    for (const CloserLook& look : looks) {
        result.most = std::max(result.most, look.most());
        crowded.insert(look.crowded().begin(), look.crowded().end());
    }
    result.crowded.assign(crowded.begin(), crowded.end());
    return result;
}

} // namespace edgeshade
