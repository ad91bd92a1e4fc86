#pragma once

#include "src/gl/capabilities.hpp"
#include "src/policy/shadow_policy.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// A ShadowPolicy's facts about a GL.
DeviceFacts deviceFactsOf(const gl::Capabilities& capabilities);

/// A ShadowPolicy's facts about a scene. Takes time linear in batches and their clusters.
SceneFacts sceneFactsOf(const LoadedScene& loaded);

/// A ShadowPolicy's facts about a visible light at rest; `loaded` has to outlive them.
LightFacts lightFactsOf(const Light& light, const LoadedScene& loaded);

/// Number of edges of casters that no animation moves.
std::size_t restingEdges(const LoadedScene& loaded);

} // namespace edgeshade
