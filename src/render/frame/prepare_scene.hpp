#pragma once

#include "src/render/frame/frame.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// Makes and uploads what the view's lights need of a scene beyond its records: groups of casters
/// that a stencil can count, planes, and primitive maps, also those that see-through surfaces alone
/// are looked up in. Kept while lights and casters rest. Throws Error(unavailable) if the GL can't.
void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const Renderer& renderer);

/// Makes the primitive maps alone; prepareScene() finds them made.
void makeLookups(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                 const Renderer& renderer);

/// Bounds the layers of those of the view's lights whose volumes are counted: of lights that are
/// looked up, whose maps must be made, nobody asks for them. A light with an extent takes a bound
/// for each of its points. `pointsAreLights`: each of these is drawn as a light of its own, which
/// no map of all of the light serves.
void boundCountedLayers(FrameView& view, const LoadedScene& loaded, const GpuScene& scene,
                        const ShadowPolicy& policy, bool pointsAreLights);

/// Decides whose primitive maps are built beside drawing, as long as the scene stays as it is.
ShadowPolicy backgroundPolicy(const GpuScene& scene, const LoadedScene& loaded,
                              const RenderSettings& settings, const gl::Capabilities& capabilities);

/// Goes on with primitive maps of those of the view's lights that are at rest, in the background,
/// or for so long where there are no threads, and forgets those of others. Returns whether one is
/// new. `policy`: backgroundPolicy().
bool prepareSceneMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                           const ShadowPolicy& policy, const PrimitiveMapSettings& settings,
                           const gl::Capabilities& capabilities, double milliseconds);

/// The map of all of a light that has an extent; null: there is none, and its points are counted
/// one by one.
const GpuPrimitiveMap* extendedMapOf(const GpuScene& scene, const Light& light);

} // namespace edgeshade
