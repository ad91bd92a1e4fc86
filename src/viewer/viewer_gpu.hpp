#pragma once

#include "src/render/frame/volume_tint_pass.hpp"
#include "src/viewer/convergence.hpp"
#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/renderers.hpp"
#include "src/viewer/smoothing.hpp"
#include "src/viewer/sun_hours.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace edgeshade::viewer {

/// Everything that a viewer has on the GPU. All of it can be dropped and made again.
class ViewerGpu {
  public:
    /// `settings`: with the layout to draw by. `mapWorker`: builds primitive maps; may be null.
    ViewerGpu(const gl::Capabilities& capabilities, const RenderSettings& settings,
              std::shared_ptr<PrimitiveMapWorker> mapWorker);

    const gl::Capabilities capabilities;
    Renderers renderers;
    Convergence convergence;
    std::optional<SunHoursCount> hours; ///< empty unless the state shows them
    Smoothing smoothing;
    Convergence sampleLights; ///< for the picture that smoothing adds next
    OverlayPass overlay;
    std::optional<GpuScene> scene;

    /// Tints the volumes of a renderer with these settings.
    VolumeTintPass& tintOf(const RenderSettings& drawn);

    VolumeRecords recordsOf(const SideSettings& side) const;

    /// The scene with the records that the state draws from. `before`: shares what is the same; may
    /// be null.
    GpuScene uploaded(const LoadedScene& loaded, const ViewState& of, const GpuScene* before) const;
    /// Uploads records of `scene` that the state draws from, and that are missing.
    void addVolumesFor(const ViewState& of, const LoadedScene& loaded);

    /// Memory of shadow data other than maps.
    std::size_t shadowBytes() const;

  private:
    std::vector<VolumeRecords> recordsFor(const ViewState& of) const;

    SidesLayout layout_;
    std::shared_ptr<PrimitiveMapWorker> mapWorker_;
    std::unique_ptr<VolumeTintPass> tint_; ///< created at first use
    MultiplicityMethod tintMethod_ = MultiplicityMethod::plane;
};

} // namespace edgeshade::viewer
