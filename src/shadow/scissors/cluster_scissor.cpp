#include "src/shadow/scissors/cluster_scissor.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/scissors/caster_grid.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// Places boxes of a batch in a light's space. Nothing of them is left out, wherever a GL puts it.
class BoxPlacer {
  public:
    BoxPlacer(const glm::dmat4& worldFromBatch, const LightSpace& space)
        : turn_(space.turn() * glm::dmat3(worldFromBatch)),
          sizes_(glm::abs(turn_[0]), glm::abs(turn_[1]), glm::abs(turn_[2])),
          origin_(space.of(glm::dvec3(worldFromBatch[3]))),
          farthest_(glm::length(origin_) + glm::length(glm::dvec3(worldFromBatch[3]))) {}

    LightBox placed(const Box& box) const {
        const glm::dvec3 middle = turn_ * box.center() + origin_;
        const double farthest =
            glm::length(sizes_ * glm::max(glm::abs(box.low), glm::abs(box.high))) + farthest_;
        const glm::dvec3 reach = sizes_ * (0.5 * (box.high - box.low)) + placingError * farthest;
        const LightBox placed{glm::vec3(middle - reach), glm::vec3(middle + reach)};
        for (glm::length_t i = 0; i < 3; ++i)
            if (!std::isfinite(placed.low[i]) || !std::isfinite(placed.high[i]))
                return LightBox::everything();
        return placed;
    }

  private:
    glm::dmat3 turn_, sizes_;
    glm::dvec3 origin_;
    double farthest_;
};

/// Grows `found` by the pixels of a block's parts whose points may be behind casters.
void look(const CasterGrid& casters, const VisiblePoints& visible,
          const std::vector<VisiblePoints::Level>& levels, std::size_t level, int x, int y,
          PixelRectangle& found) {
    const VisiblePoints::Block& block = levels[level].at(x, y);
    if (block.empty()) return;
    const PixelRectangle pixels = visible.pixelsOf(level, x, y);
    if (intersection(pixels, found) == pixels || !casters.mayBeBehind(block)) return;
    if (level == 0) {
        found = united(found, pixels);
        return;
    }
    for (int part = 0; part < 4; ++part) {
        const int px = 2 * x + part % 2, py = 2 * y + part / 2;
        if (px < levels[level - 1].width && py < levels[level - 1].height)
            look(casters, visible, levels, level - 1, px, py, found);
    }
}

} // namespace

PixelRectangle scissorOf(const BatchPlan& batch, const ShadowCluster& cluster,
                         const VisiblePoints& visible) {
    const BoxPlacer placer(batch.worldFromBatch, visible.space());
    PixelRectangle found;
    std::vector<FaceExtent> casters;
    for (std::size_t face = 0; face < visible.space().faceCount(); ++face) {
        const auto& levels = visible.levelsOf(face);
        if (levels.empty()) continue;
        casters.clear();
        for (std::uint32_t i = cluster.leaves.first; i < cluster.leaves.end(); ++i) {
            const FaceExtent extent =
                visible.space().extentIn(face, placer.placed(batch.shadow->leaves[i]));
            if (!extent.empty()) casters.push_back(extent);
        }
        if (!casters.empty())
            look(CasterGrid(casters), visible, levels, levels.size() - 1, 0, 0, found);
    }
    return found;
}

} // namespace edgeshade
