#pragma once

#include "src/gl/capabilities.hpp"
#include "src/policy/shadow_policy.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// What a ShadowPolicy asks of a GL.
DeviceFacts deviceFactsOf(const gl::Capabilities& capabilities);

/// What a ShadowPolicy asks of a scene. Takes time linear in batches and their clusters.
SceneFacts sceneFactsOf(const LoadedScene& loaded);

/// What a ShadowPolicy asks of a light at rest that is seen; `loaded` has to outlive it.
LightFacts lightFactsOf(const Light& light, const LoadedScene& loaded);

/// Edges of casters that no animation moves.
std::size_t restingEdges(const LoadedScene& loaded);

} // namespace edgeshade
