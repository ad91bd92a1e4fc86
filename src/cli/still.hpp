#pragma once

#include "src/gl/headless_context.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace edgeshade::cli {

/// A picture, drawn at leisure.
struct StillTask {
    FrameRequest request;
    std::size_t subpixels = 1; ///< pictures that are averaged, see subpixelOffset()
    bool mask = false;         ///< the first light's: 255 * what of it is seen, rounded
    bool shadeSamples = false; ///< lights with an extent shade by each point
    bool firstIsDown = false;  ///< the first light shines on nothing
    std::optional<std::size_t> shadowedLights{}; ///< see chooseLights()
    /// Once the scene is prepared for the first picture, before that is drawn; null: nothing.
    std::function<void()> prepared{};
};

/// Whether a mask is more than lit or not.
bool isGrey(const StillTask& task);

/// The frame of the task's n-th picture. `tree`: the scene's. `like`: that of another one, whose
/// layers are the same; null: none, and its layers are left to boundCountedLayers().
FrameView viewOf(const LoadedScene& loaded, const SceneTree& tree, const StillTask& task,
                 std::size_t n, const FrameView* like = nullptr);

/// Draws it: RGBA, rows top to bottom. `first`: viewOf() of 0. The last picture is `renderer`'s.
/// `progress` gets the share done. Throws Error(usage) for more masks than can be added up, and
/// Error(unavailable) where lights can't be.
std::vector<std::uint8_t> drawStill(const LoadedScene& loaded, const SceneTree& tree,
                                    const StillTask& task, const FrameView& first,
                                    Renderer& renderer, GpuScene& scene,
                                    const gl::HeadlessContext& context,
                                    const std::function<void(double)>& progress);

} // namespace edgeshade::cli
