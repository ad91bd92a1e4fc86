#pragma once

#include "src/shadow/layers/crowded_parts.hpp"
#include "src/shadow/layers/touch_grid.hpp"

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

namespace edgeshade {

/// The rectangle with all segments and polygons of a face, with some room; empty() if there are
/// none on the face. The count is constant on each part of the rest of the face, up to the
/// rectangle.
Outline filledPart(const FaceChain& face, const LightView& view);

/// Bounds how many triangles the lines through a light's faces meet, face by face: in a grid, and
/// in finer grids within the cells where that is too coarse (docs/method.md, C48). It keeps its
/// memory for the next light.
class FaceBound {
  public:
    explicit FaceBound(std::size_t limit = 0) { begin(limit); }

    /// Starts with a light's first face.
    void begin(std::size_t limit);

    /// Whether no line through the face meets more than `limit` triangles; false also if that
    /// couldn't be shown. `part`: its filledPart(). `start`: an upper bound of the number of
    /// certain triangles just below and to the left of the part's first corner; for an empty part,
    /// anywhere on the face.
    bool holds(const FaceChain& face, const Outline& part, int start);

    /// The most triangles that a line may meet, if holds() was true for all faces.
    int most() const { return most_; }

  private:
    /// A part of a face, and all that may touch it.
    struct Part {
        Outline outline;
        int halvings; ///< of the face's filled part
        std::span<const FaceSegment> segments;
        std::span<const FacePolygon> uncertain;
        int start;
        bool isRaised; ///< `start` is, as of WindingGrid::sum()
    };
    /// Memory for the parts of one nesting.
    struct Level {
        WindingGrid grid;
        TouchGrid touched;
        std::vector<int> placeOf; ///< by segment
        CrowdedParts crowded;
    };
    bool holds(const Part& part, int depth, std::size_t nesting);

    int limit_ = 0, most_ = 0;
    double error_ = 0.0;       ///< as of FaceChain
    std::size_t workLeft_ = 0; ///< segments and polygons that may still be put into crowded cells
    std::deque<Level> levels_; ///< by nesting; stay where they are
};

} // namespace edgeshade
