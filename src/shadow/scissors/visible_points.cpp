#include "src/shadow/scissors/visible_points.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// What is left of the depth range behind a pixel's point, in 2^-24 of it.
std::int32_t leftBehind(std::uint32_t depth) {
    return static_cast<std::int32_t>(~depth >> 8);
}

float shareOf(std::int32_t left) {
    return static_cast<float>(left) * 0x1p-24f;
}

constexpr std::int32_t allLeft = 1 << 24;

} // namespace

VisiblePoints::VisiblePoints(const DepthPicture& depths, const FrameView& view,
                             const DepthSlice& slice, const Light& light,
                             const PixelRectangle& reach)
    : depths_(depths), space_(light, view.frustum.position()),
      rays_(view, slice, space_, depths.bits),
      reach_(intersection(reach, {0, 0, depths.width, depths.height})), faces_(space_.faceCount()) {
    if (!reach_.empty()) addBlocks();
    for (std::vector<Level>& levels : faces_)
        while (!levels.empty() && (levels.back().width > 1 || levels.back().height > 1)) {
            const Level& fine = levels.back();
            Level coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
            for (int y = 0; y < fine.height; ++y)
                for (int x = 0; x < fine.width; ++x)
                    coarse.at(x / 2, y / 2).add(fine.at(x, y));
            levels.push_back(std::move(coarse));
        }
}

PixelRectangle VisiblePoints::pixelsOf(std::size_t level, int x, int y) const {
    const int size = blockSize << level;
    return intersection({x * size, y * size, size, size}, reach_);
}

void VisiblePoints::addBlocks() {
    const auto width = static_cast<std::size_t>(depths_.width);
    std::vector<std::int32_t> least(width), most(width);
    for (int y = reach_.y / blockSize; y * blockSize < reach_.y + reach_.height; ++y) {
        least.assign(width, allLeft);
        most.assign(width, 0);
        const int end = std::min((y + 1) * blockSize, reach_.y + reach_.height);
        for (int row = std::max(y * blockSize, reach_.y); row < end; ++row) {
            const std::uint32_t* depth = &depths_.at(0, row);
            for (std::size_t x = 0; x < width; ++x) {
                const std::int32_t left = leftBehind(depth[x]);
                least[x] = std::min(least[x], left != 0 ? left : allLeft);
                most[x] = std::max(most[x], left);
            }
        }
        for (int x = reach_.x / blockSize; x * blockSize < reach_.x + reach_.width; ++x) {
            const PixelRectangle pixels = pixelsOf(0, x, y);
            std::int32_t leastLeft = allLeft, mostLeft = 0;
            for (int column = pixels.x; column < pixels.x + pixels.width; ++column) {
                leastLeft = std::min(leastLeft, least[static_cast<std::size_t>(column)]);
                mostLeft = std::max(mostLeft, most[static_cast<std::size_t>(column)]);
            }
            if (mostLeft == 0) continue;
            addBlock(x, y,
                     rays_.fit() ? rays_.boxOf(pixels, shareOf(leastLeft), shareOf(mostLeft))
                                       .grown(rays_.errorAt(shareOf(leastLeft)))
                                 : LightBox::everything());
        }
    }
}

void VisiblePoints::addBlock(int x, int y, const LightBox& box) {
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const FaceExtent extent = space_.extentIn(face, box);
        if (extent.empty()) continue;
        std::vector<Level>& levels = faces_[face];
        if (levels.empty())
            levels.emplace_back((depths_.width + blockSize - 1) / blockSize,
                                (depths_.height + blockSize - 1) / blockSize);
        levels.front().at(x, y) = extent;
    }
}

} // namespace edgeshade
