#pragma once

#include "src/gl/headless_context.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace edgeshade::cli {

/// A single picture, for which time does not matter.
struct StillTask {
    FrameRequest request;
    std::size_t subpixels = 1; ///< number of pictures to average, see subpixelOffset()
    bool mask = false;         ///< the first light's mask: 255 times its visible share, rounded
    bool shadeSamples = false; ///< each point of a light with an extent shades by itself
    bool firstIsDown = false;  ///< the first light shines on nothing
    std::optional<std::size_t> shadowedLights{}; ///< see chooseLights()
    /// Called once the scene is prepared for the first picture, before drawing; may be null.
    std::function<void()> prepared{};
};

/// Whether a mask can have values between lit and shadowed.
bool isGrey(const StillTask& task);

/// The frame of the task's n-th picture. `tree`: the scene's. `like`: another picture's frame,
/// whose layers it takes; null: it leaves its layers to boundCountedLayers().
FrameView viewOf(const LoadedScene& loaded, const SceneTree& tree, const StillTask& task,
                 std::size_t n, const FrameView* like = nullptr);

/// Draws the task: RGBA, rows top to bottom. `first`: viewOf() of picture 0. Afterwards `renderer`
/// has the plan of the last picture. `progress` receives the share done. Throws Error(usage) for
/// more masks than can be added up, and Error(unavailable) if the GL can't add up lights.
std::vector<std::uint8_t> drawStill(const LoadedScene& loaded, const SceneTree& tree,
                                    const StillTask& task, const FrameView& first,
                                    Renderer& renderer, GpuScene& scene,
                                    const gl::HeadlessContext& context,
                                    const std::function<void(double)>& progress);

} // namespace edgeshade::cli
