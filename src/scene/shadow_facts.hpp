#pragma once

#include "src/scene/gpu_scene.hpp"
#include "src/scene/scene_facts.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// What a ShadowPolicy asks of a scene on the GPU, as far as choose() needs it.
SceneFacts sceneFactsOf(const GpuScene& scene);

/// What a ShadowPolicy asks of a frame's light, but for `reachesSeeThrough`.
LightFacts lightFactsOf(const FrameLight& light);

/// What became of a light's primitive map, whichever passes ask it.
LookupFacts lookupFactsOf(const GpuScene& scene, const Light& light);

/// The same for one pass: the map of all of an extended light answers only for many places at once.
LookupFacts lookupFactsOf(const GpuScene& scene, const FrameLight& light);

} // namespace edgeshade
