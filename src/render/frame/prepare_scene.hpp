#pragma once

#include "src/render/volumes/render_settings.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/frame_view.hpp"

namespace edgeshade {

/// Makes and uploads what the view's lights need of a scene beyond its records: groups of casters
/// that a stencil can count, planes, and primitive maps, also those that see-through surfaces alone
/// are looked up in. Kept while lights and casters rest. For a renderer of `settings` in the
/// context of `capabilities`. Throws Error(unavailable) if the GL can't.
void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const RenderSettings& settings, const gl::Capabilities& capabilities);

/// Goes on with primitive maps of those of the view's lights that are at rest, in the background,
/// or for so long where there are no threads, and forgets those of others. Returns whether one is
/// new.
bool prepareSceneMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                           const RenderSettings& settings, const gl::Capabilities& capabilities,
                           double milliseconds);

/// Whether casters are left out that are wholly in the shadow of others: the settings ask for it,
/// and what casts has no holes and is seen from both sides.
bool mayCullCasters(const LoadedScene& loaded, const FrameView& view,
                    const RenderSettings& settings);

/// Goes on finding casters that are wholly in the shadow of others, if they may be left out, in the
/// background: for those of the view's lights that rest or wander, and forgets those of others.
/// Returns whether some are new.
bool cullCastersMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                          const RenderSettings& settings, const gl::Capabilities& capabilities);

/// The map of all of a light that has an extent; null: there is none, and its points are counted
/// one by one.
const GpuPrimitiveMap* extendedMapOf(const GpuScene& scene, const Light& light);

/// How a light's shadows are made.
struct LightMethod {
    std::string method;   ///< as --shadows has it
    std::string why;      ///< a clause, of a map or planes what they are; empty: it was asked for
    double buildMs = 0.0; ///< of its primitive map or the scene's planes, on the CPU
    std::size_t bytes = 0;
};

/// Of each of the view's lights, in a scene that is prepared. Of shadow maps without their bytes.
std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const RenderSettings& settings);

} // namespace edgeshade
