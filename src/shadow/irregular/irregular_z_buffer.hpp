#pragma once

#include "preprocess/base/parallel.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/irregular/caster_runs.hpp"
#include "src/shadow/irregular/point_tree.hpp"
#include "src/shadow/irregular/sight_lines.hpp"
#include "src/shadow/scissors/depth_picture.hpp"

#include <span>

namespace edgeshade {

/// Casting triangles, somewhere in the world.
struct PlacedRuns {
    const CasterRuns* casters = nullptr;
    glm::dmat4 worldFromBatch{1.0};
};

/// How far off a rasteriser puts what it draws.
struct RasterRounding {
    int subpixelBits = 4;   ///< vertices are put on a grid of 2^-subpixelBits pixels
    double depth = 0x1p-21; ///< of the depth range, beside what its bits leave
};

/// Which visible points of a picture a light doesn't reach, found point by point: an irregular
/// z-buffer (Johnson et al. 2005, Aila and Laine 2004), which the processor draws casters into. A
/// point is taken to be just before what is seen there, as it is where volumes are counted, and is
/// in shadow if a triangle is between it and the light (docs/method.md, C46).
class IrregularZBuffer {
  public:
    /// Of a slice whose depth buffer this is a rectangle of, within `reach`. `depths` must
    /// outlive it.
    IrregularZBuffer(const DepthPicture& depths, const FrameView& view, const DepthSlice& slice,
                     const Light& light, const PixelRectangle& reach,
                     const RasterRounding& rounding, Threads threads = {});

    void cast(std::span<const PlacedRuns> casters, Threads threads = {});

    /// By pixel of the rectangle, rows from below: 255 where something is in shadow, else 0.
    const std::vector<std::uint8_t>& shadowed() const { return shadowed_; }

  private:
    struct Vertex {
        glm::dvec3 place{0.0}; ///< in the light's space
        glm::vec3 own{0.0f};   ///< in the frame of its face
        std::size_t face = 0;
    };
    struct Triangle {
        const Vertex &a, &b, &c;

        bool onOneFace() const { return a.face == b.face && a.face == c.face; }
    };
    struct Corners;
    struct Scratch;

    void addPoints(const PixelRectangle& within, Threads threads);
    void castRun(const CasterRuns& casters, const CasterRuns::Run& run,
                 const glm::dmat4& worldFromBatch, Scratch& scratch);
    /// Whether some groups of points may be behind the run, which are in `scratch` then.
    bool gatherFor(const Box& bounds, const glm::dmat4& worldFromBatch, Scratch& scratch) const;
    Vertex vertexAt(const glm::dvec3& world) const;
    void cast(const Triangle& triangle, std::size_t face, Scratch& scratch);
    CasterBox boxOn(std::size_t face, const Triangle& triangle) const;
    Corners cornersOf(const Triangle& triangle) const;
    void see(Corners& corners) const;
    CasterPlanes planesOn(std::size_t face, const Corners& corners) const;
    bool isShadowed(const Corners& corners, Pixel pixel) const;
    /// Calls use(pixel, face, rays) for every step-th visible point of each four rows and columns.
    template <class Use>
    void forEachPoint(const PixelRectangle& of, int step, Use use) const;

    std::size_t indexOf(Pixel pixel) const {
        return static_cast<std::size_t>(pixel.row) * static_cast<std::size_t>(depths_.width) +
               pixel.column;
    }
    bool isEmpty(Pixel pixel) const { return depths_.depths[indexOf(pixel)] == 0xFFFFFFFF; }
    /// What is left of the depth range behind a point that is certainly before what is seen.
    double leftOf(Pixel pixel) const {
        return static_cast<double>(~depths_.depths[indexOf(pixel)]) * (1.0 / 4294967295.0) +
               depthError_;
    }

    const DepthPicture& depths_;
    LightSpace space_;
    SightLines lines_;
    double depthError_; ///< what depths, as they are kept, are off by
    double snapError_;  ///< pixels, that a rasteriser moves vertices by
    std::vector<PointTree> faces_;
    std::vector<std::uint8_t> shadowed_;
};

} // namespace edgeshade
