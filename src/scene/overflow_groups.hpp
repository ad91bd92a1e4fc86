#pragma once

#include "src/scene/batch_volumes.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>
#include <vector>

namespace edgeshade {

/// Shadow data in groups that a stencil can each count: by group, then by batch.
using GroupedShadow = std::vector<std::vector<BatchVolumes>>;

/// A scene's casters in groups on the GPU, kept while the lights rest. They serve lights around
/// which more shadow volumes may overlap than a stencil counts (LayerBound), and lights whose
/// casters are cut (FrameLight::cut).
class OverflowGroups {
  public:
    /// Builds and uploads missing groups for the lights' layers, and deletes those that no light
    /// needs. Call clear() first if batches have moved.
    void upload(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                VolumeRecords records);

    /// The light's groups in one layout; null if it needs none, or they aren't uploaded.
    GroupedShadow* of(const FrameLight& light, VolumeLayout layout);
    const GroupedShadow* of(const FrameLight& light, VolumeLayout layout) const;

    void clear() { kept_.clear(); }
    std::size_t sideBytes() const;
    std::size_t capBytes() const;

  private:
    struct Kept {
        glm::dvec4 light; ///< its position, or the middle of its points
        double range;     ///< casters beyond it may be in any group
        std::optional<glm::dvec4> cut;
        std::map<VolumeLayout, GroupedShadow> groups;

        bool isOf(const glm::dvec4& place, const FrameLight& of) const {
            return light == place && range == of.light.range && cut == of.cut;
        }
    };
    std::vector<Kept> kept_;
};

} // namespace edgeshade
