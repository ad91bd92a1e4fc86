#pragma once

#include "src/shadow/geometry/frame_view.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/scissors/depth_picture.hpp"
#include "src/shadow/scissors/light_space.hpp"
#include "src/shadow/scissors/picture_rays.hpp"

#include <vector>

namespace edgeshade {

/// Where the visible points of a picture are in a light's space: in blocks of 4 x 4 pixels, in
/// blocks of 2 x 2 of these, and so on up to one block. The bounds of blocks hold what rounding in
/// a GL and the grid that its rasteriser puts vertices on may do.
class VisiblePoints {
  public:
    static constexpr int blockSize = 4; ///< pixels of the smallest blocks along a side

    /// What blocks of one size have of a face, by row from below.
    struct Level {
        int width = 0, height = 0;
        std::vector<FaceExtent> blocks;

        Level(int columns, int rows)
            : width(columns), height(rows),
              blocks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
        FaceExtent& at(int x, int y) { return blocks[indexOf(x, y)]; }
        const FaceExtent& at(int x, int y) const { return blocks[indexOf(x, y)]; }

      private:
        std::size_t indexOf(int x, int y) const {
            return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x);
        }
    };
    /// Those of a slice whose whole depth buffer this is, within `reach`. `depths` must outlive it.
    VisiblePoints(const DepthPicture& depths, const FrameView& view, const DepthSlice& slice,
                  const Light& light, const PixelRectangle& reach);

    const LightSpace& space() const { return space_; }
    /// By size, the smallest blocks first; nothing where the face has none.
    const std::vector<Level>& levelsOf(std::size_t face) const { return faces_[face]; }
    /// The pixels of a block, those within reach.
    PixelRectangle pixelsOf(std::size_t level, int x, int y) const;

  private:
    void addBlocks();
    void addBlock(int x, int y, const LightBox& box);

    const DepthPicture& depths_;
    LightSpace space_;
    PictureRays rays_;
    PixelRectangle reach_;
    std::vector<std::vector<Level>> faces_;
};

} // namespace edgeshade
