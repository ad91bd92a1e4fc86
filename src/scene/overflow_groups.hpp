#pragma once

#include "src/scene/batch_volumes.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>
#include <vector>

namespace edgeshade {

/// Shadow data in groups, each of which a stencil can count: by group, then by batch.
using GroupedShadow = std::vector<std::vector<BatchVolumes>>;

/// A scene's casters in groups on the GPU, for the lights around which more shadow volumes may
/// overlap than a stencil counts (LayerBound), and for those whose casters are cut
/// (FrameLight::cut), kept while the lights rest.
class OverflowGroups {
  public:
    /// Builds and uploads the groups that the lights' layers ask for and that are not there yet,
    /// and forgets those that they don't. If batches have moved since, clear() comes first.
    void upload(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                VolumeRecords records);

    /// The light's groups of one layout; null where it needs none, or nobody has uploaded them.
    GroupedShadow* of(const FrameLight& light, VolumeLayout layout);
    const GroupedShadow* of(const FrameLight& light, VolumeLayout layout) const;

    void clear() { kept_.clear(); }
    std::size_t sideBytes() const;
    std::size_t capBytes() const;

  private:
    struct Kept {
        glm::dvec4 light; ///< its place, or the middle of its points
        double range;     ///< beyond which casters are in no certain group
        std::optional<glm::dvec4> cut;
        std::map<VolumeLayout, GroupedShadow> groups;

        bool isOf(const glm::dvec4& place, const FrameLight& of) const {
            return light == place && range == of.light.range && cut == of.cut;
        }
    };
    std::vector<Kept> kept_;
};

} // namespace edgeshade
