#pragma once

#include "src/scene/gpu_scene.hpp"
#include "src/scene/scene_facts.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// A ShadowPolicy's facts about a scene on the GPU, as far as choose() needs them.
SceneFacts sceneFactsOf(const GpuScene& scene);

/// A ShadowPolicy's facts about a frame's light, without `reachesSeeThrough`.
LightFacts lightFactsOf(const FrameLight& light);

/// State of a light's primitive map, for passes of any kind.
LookupFacts lookupFactsOf(const GpuScene& scene, const Light& light);

/// The state for one pass: the map of a whole extended light serves only passes over many points at
/// once.
LookupFacts lookupFactsOf(const GpuScene& scene, const FrameLight& light);

} // namespace edgeshade
