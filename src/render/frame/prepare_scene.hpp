#pragma once

#include "src/render/frame/frame.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// Creates and uploads what the view's lights need of a scene beyond its records: groups of casters
/// that the stencil can count, shadow planes, and primitive maps, also those that only see-through
/// surfaces sample. Everything is kept while lights and casters rest. Throws Error(unavailable) if
/// the GL can't.
void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const Renderer& renderer);

/// Makes only the primitive maps; prepareScene() then finds them made.
void makeLookups(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                 const Renderer& renderer);

/// Bounds the layers of the view's lights whose volumes are counted. Lights with a lookup need no
/// bound; their maps must be made before. A light with an extent gets a bound for each of its
/// points. `pointsAreLights`: each of these points is drawn as a light of its own, which a map of
/// the whole light can't serve.
void boundCountedLayers(FrameView& view, const LoadedScene& loaded, const GpuScene& scene,
                        const ShadowPolicy& policy, bool pointsAreLights);

/// The policy that decides which primitive maps are built in the background, for as long as the
/// scene stays as it is.
ShadowPolicy backgroundPolicy(const GpuScene& scene, const LoadedScene& loaded,
                              const RenderSettings& settings, const gl::Capabilities& capabilities);

/// Continues building primitive maps for the view's lights at rest, in the background, or for
/// `milliseconds` if there are no threads, and discards those of other lights. Returns whether a
/// map is new. `policy`: backgroundPolicy().
bool prepareSceneMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                           const ShadowPolicy& policy, const PrimitiveMapSettings& settings,
                           const gl::Capabilities& capabilities, double milliseconds);

/// The map of a whole light with an extent; null: there is none, and its points are counted one at
/// a time.
const GpuPrimitiveMap* extendedMapOf(const GpuScene& scene, const Light& light);

} // namespace edgeshade
