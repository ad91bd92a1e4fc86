#include "src/shadow/scissors/cluster_scissors.hpp"

#include "src/shadow/scissors/caster_grid.hpp"

namespace edgeshade {
namespace {

/// Grows `found` by the pixels of a block's parts whose points may be behind casters.
void look(const CasterGrid& casters, const VisiblePoints& visible,
          const std::vector<VisiblePoints::Level>& levels, std::size_t level, int x, int y,
          PixelRectangle& found) {
    const FaceExtent& block = levels[level].at(x, y);
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

ClusterScissors::ClusterScissors(const BatchPlan& batch, const VisiblePoints& visible)
    : leaves_(batch.shadow->leaves), visible_(visible),
      placer_(batch.worldFromBatch, visible.space()) {}

PixelRectangle ClusterScissors::of(const ShadowCluster& cluster) const {
    std::vector<LightBox> boxes;
    for (std::uint32_t i = cluster.leaves.first; i < cluster.leaves.end(); ++i)
        boxes.push_back(placer_.placed(leaves_[i]));
    PixelRectangle found;
    std::vector<FaceExtent> casters;
    for (std::size_t face = 0; face < visible_.space().faceCount(); ++face) {
        const auto& levels = visible_.levelsOf(face);
        if (levels.empty()) continue;
        casters.clear();
        for (const LightBox& box : boxes) {
            const FaceExtent extent = visible_.space().extentIn(face, box);
            if (!extent.empty()) casters.push_back(extent);
        }
        if (!casters.empty())
            look(CasterGrid(casters), visible_, levels, levels.size() - 1, 0, 0, found);
    }
    return found;
}

} // namespace edgeshade
