// Renderer: the light that each light adds to the picture, and how lights are combined.

#include "src/environment/neutral.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/pass_state.hpp"
#include "src/render/volumes/stencil_count.hpp"
#include "src/settings/build_parts.hpp"

#include <algorithm>
#include <cmath>
#include <GLES2/gl2.h>
#include <numbers>

namespace edgeshade {
namespace {

/// Number of lights, in a picture without shadows, from which they are listed; fewer take a pass
/// each.
constexpr std::size_t manyUnshadowed = 9;

/// The origin of lines of sight, relative to the camera's position.
glm::vec4 eyeFrom(const Frustum& frustum) {
    const glm::dvec4 eye = frustum.eye();
    return glm::vec4(glm::dvec3(eye) - frustum.position() * eye.w, eye.w);
}

/// The share of white light that the display shows as `displayed`.
float lightShown(float displayed) {
    return std::pow(displayed, 2.2f);
}

/// Slope of the neutral environment: how much more light a white surface reflects facing up than
/// facing sideways (neutralRadiance(), to first order).
constexpr float neutralSlope = 0.59f;

/// Whether plain surfaces need only a power function, no tone curve: all light is white, and
/// nothing is brighter than the display shows.
bool isPlain(const RenderSettings& settings) {
    return settings.exposure <= 0.0f && !settings.environment;
}

bool isPlain(const Light& light) {
    const glm::vec3& color = light.color;
    return !light.photometric && color.r == color.g && color.g == color.b && color.r <= 1.0f;
}

} // namespace

Renderer::LightSum Renderer::lightSum(const GpuScene& scene, const FrameView& view) const {
    LightSum sum;
    for (const FrameLight& of : view.lights)
        sum.lights += of.weight;
    if (settings_.shading == Shading::base || view.mask || settings_.tintPrimitives) return sum;
    sum.full = true;
    sum.replaces = view.lights.size() == 1;
    // Plain for all surfaces or for none: Neutral shows dark and deep colours darker than the short
    // way.
    sum.plainIsShort =
        sum.replaces && scene.plain && isPlain(settings_) && isPlain(view.lights.front().light);
    return sum;
}

void Renderer::prepareSum(const GpuScene& scene, const FrameView& view) {
    if (!sum_.full) return;
    const bool reflects = !sum_.plainIsShort || scene.seeThrough;
    if (reflects && !environment_)
        environment_.emplace(settings_.environment ? *settings_.environment : neutralEnvironment());
    sum_.linear = !sum_.replaces && linear_ && linear_->bind(view.width, view.height);
}

void Renderer::addLight(const SlicePass& pass, std::size_t light) {
    const LightPlan& plan = pass.plan.lights[light];
    const StageScope stage(pass.clock, FrameStage::lit);
    const bool counted = plan.isCounted() && !coarse_ && !plan.inGroups();
    if (!counted) clearStencil();
    set(passes::addingLight(plan.inGroups() && !coarse_, sum_.replaces));
    drawLit(pass, light);
}

bool Renderer::mayBeListed(const FrameView& view, std::size_t light) const {
    if (visibilityOf(light) || settings_.tintPrimitives) return false;
    return !view.lights[light].shadowed ||
           (settings_.shadows == ShadowMethod::none && view.lights.size() >= manyUnshadowed);
}

void Renderer::uploadListed(const SlicePass& pass) {
    if constexpr (listsLights) {
        const StageScope stage(pass.clock, FrameStage::lit);
        listed_ = table_->upload(*pass.plan.lists, pass.view, [&](std::size_t light) {
            const SurfaceShading shading = shadingOf(pass, light);
            return shading.full ? shading.full->lightColor : glm::vec3(shading.diffuse);
        });
    }
}

SurfaceShading Renderer::listedShading(const SlicePass& pass) const {
    SurfaceShading shading = shadingOf(pass, {});
    shading.listed = &listed_;
    shading.diffuse = std::max(1.0f - shading.ambient, 0.0f) / static_cast<float>(sum_.lights);
    return shading;
}

void Renderer::addListed(const SlicePass& pass) {
    const StageScope stage(pass.clock, FrameStage::lit);
    const gl::ScissorScope cut(pass.plan.lists->reach);
    clearStencil();
    set(passes::addingLight(false, sum_.replaces));
    drawSurfaces(pass.scene, pass.view, pass.slice, listedShading(pass));
    glDisable(GL_STENCIL_TEST);
}

SurfaceShading Renderer::shadingOf(const SlicePass& pass, std::optional<std::size_t> index) const {
    SurfaceShading shading;
    shading.mask = pass.view.mask;
    shading.farthest = static_cast<float>(pass.slice.far * sliceOverlap);
    shading.ambient = settings_.ambient;
    shading.background = settings_.background;
    shading.lights = sum_.lights;
    if (sum_.full) setFull(pass, shading);
    if (!index) return shading;
    const FrameLight& of = pass.view.lights[*index];
    const Light& light = of.light;
    shading.light = light;
    // A surface that faces up, straight towards all lights, is shown in its own colour.
    const float ambient = shading.ambient * (shading.full ? 1.0f + neutralSlope : 1.0f);
    const auto weight = static_cast<float>(of.weight);
    const float share =
        std::max(1.0f - ambient, 0.0f) * weight / static_cast<float>(shading.lights);
    shading.weight = of.weight;
    shading.diffuse = share;
    if (shading.full) {
        shading.full->lightColor =
            light.color * (light.photometric ? weight * std::numbers::inv_pi_v<float> : share);
        shading.diffuse = shading.full->lightColor.r;
    }
    shading.withAmbient = sum_.replaces;
    shading.visibility = visibilityOf(*index);
    const ShadowTechnique* technique = techniqueOf(*index);
    if (technique) shading.primitives = technique->primitivesOf(pass.scene, light);
    if (of.atOnce) shading.places = of.points;
    shading.eye = pass.view.frustum.eye();
    shading.tintPrimitives = settings_.tintPrimitives && !pass.view.mask;
    shading.selfShadowed = technique && technique->leavesFacing() && shading.mask;
    shading.maskValue = pass.view.sumsMasks ? 1.0f / static_cast<float>(mostSummed) : 1.0f;
    return shading;
}

void Renderer::setFull(const SlicePass& pass, SurfaceShading& shading) const {
    FullShading& full = shading.full.emplace();
    full.plainIsShort = sum_.plainIsShort;
    full.environment = environment_ ? &*environment_ : nullptr;
    full.softTerminator = settings_.softTerminator;
    full.linear = sum_.linear;
    full.exposure = std::exp2(settings_.exposure);
    shading.ambient = lightShown(settings_.ambient);
    full.ambientSlope = neutralSlope * shading.ambient;
    full.eye = eyeFrom(pass.view.frustum);
}

void Renderer::drawLit(const SlicePass& pass, std::size_t light) {
    SurfaceShading shading = shadingOf(pass, light);
    // A host knows facing, cones and ranges itself, so that surfaces needn't be drawn again.
    if (shading.mask && pass.view.lights[light].animatedAlone)
        return mark_.addValue(shading.maskValue);
    shading.map = mapOf(light);
    CoarseMaskLookup mask;
    if (coarse_ && !shading.primitives && !shading.visibility) {
        mask = coarse_->lookup(pass.view, pass.slice, pass.view.lights[light].light);
        shading.coarse = &mask;
    }
    drawSurfaces(pass.scene, pass.view, pass.slice, shading);
}

} // namespace edgeshade
