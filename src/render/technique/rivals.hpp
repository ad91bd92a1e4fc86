#pragma once

#include "src/scene/record_source.hpp"

#include <memory>
#include <optional>

namespace edgeshade {

namespace gl {
struct Capabilities;
}
class ShadowMapPass;
class ShadowTechnique;
class VolumeRenderer;
struct RenderSettings;
struct VolumeTints;

/// Methods that a program adds to the library's own for comparison, see src/rivals. A member
/// returns null for a method that the set lacks.
class Rivals {
  public:
    virtual ~Rivals() = default;

    /// Makes the records of a layout.
    virtual const RecordSource* records(VolumeLayout layout) const = 0;

    /// Draws shadow volumes from the records that `settings` require. `tints`: for debug views.
    virtual std::unique_ptr<VolumeRenderer>
    volumes(const RenderSettings& settings, const gl::Capabilities& capabilities,
            const std::optional<VolumeTints>& tints) const = 0;

    /// Draws shadow maps of the kinds and filters that ShadowMapSettings::isPlain() excludes.
    virtual std::unique_ptr<ShadowMapPass> maps(const RenderSettings& settings,
                                                const gl::Capabilities& capabilities) const = 0;

    /// Projects shadows onto planes.
    virtual std::unique_ptr<ShadowTechnique> planar(const RenderSettings& settings) const = 0;
};

} // namespace edgeshade
