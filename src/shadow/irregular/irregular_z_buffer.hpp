#pragma once

#include "preprocess/base/parallel.hpp"
#include "src/shadow/irregular/caster_runs.hpp"
#include "src/shadow/irregular/point_tree.hpp"
#include "src/shadow/irregular/seen_triangles.hpp"
#include "src/shadow/irregular/sight_lines.hpp"

#include <span>

namespace edgeshade {

/// Casting triangles with their transform to the world.
struct PlacedRuns {
    const CasterRuns* casters = nullptr;
    glm::dmat4 worldFromBatch{1.0};
};

/// The visible points of a picture that a light doesn't reach, found point by point: an irregular
/// z-buffer (Johnson et al. 2005, Aila and Laine 2004), into which the processor draws casters. A
/// point is where its pixel's line of sight meets the triangle visible there, in double precision.
/// It is in shadow if that triangle faces away from the light, or another one is between it and the
/// light (docs/method.md, C46).
class IrregularZBuffer {
  public:
    /// Tests the points within `reach`. `seen` must outlive it.
    IrregularZBuffer(const SeenTriangles& seen, const FrameView& view, const Light& light,
                     const PixelRectangle& reach, Threads threads = {});

    void cast(std::span<const PlacedRuns> casters, Threads threads = {});

    /// For each pixel of the rectangle, rows from below: 255 if its point is in shadow, otherwise
    /// 0.
    const std::vector<std::uint8_t>& shadowed() const { return shadowed_; }

  private:
    struct Vertex {
        glm::dvec3 place{0.0}; ///< in the light's space
        glm::vec3 own{0.0f};   ///< in its face's frame
        std::size_t face = 0;
    };
    struct Triangle {
        const Vertex &a, &b, &c;

        bool onOneFace() const { return a.face == b.face && a.face == c.face; }
    };
    struct Corners;
    struct OwnTriangle;
    struct Scratch;
    struct PlacedInLight;

    OwnTriangle ownTriangle(std::uint32_t number) const;
    void findPlaces(const PixelRectangle& within, Threads threads);
    void addPoints(const PixelRectangle& within, Threads threads);
    void castRun(const PlacedInLight& casters, const CasterRuns::Run& run, Scratch& scratch);
    /// Whether any groups of points may be behind the run; they are then in `scratch`.
    bool gatherFor(const Box& bounds, const glm::dmat4& lightFromBatch, Scratch& scratch) const;
    Vertex vertexAt(const glm::dvec3& place) const;
    void cast(const Triangle& triangle, std::size_t face, Scratch& scratch);
    CasterBox boxOn(std::size_t face, const Triangle& triangle) const;
    Corners cornersOf(const Triangle& triangle) const;
    CasterPlanes planesOn(std::size_t face, const Corners& corners) const;
    bool isShadowed(const Corners& corners, Pixel pixel) const;
    /// Calls use(pixel, face, rays) for points to test, in blocks of four by four pixels, at every
    /// step-th row and column of a block.
    template <class Use>
    void forEachPoint(const PixelRectangle& of, int step, Use use) const;

    std::size_t indexOf(Pixel pixel) const {
        return static_cast<std::size_t>(pixel.row) * static_cast<std::size_t>(seen_.area.width) +
               pixel.column;
    }

    const SeenTriangles& seen_;
    Light light_;
    LightSpace space_;
    SightLines lines_;
    std::vector<glm::dvec3> places_; ///< by pixel, in the light's space, for points to test
    std::vector<PointTree> faces_;
    std::vector<std::uint8_t> shadowed_;
};

} // namespace edgeshade
