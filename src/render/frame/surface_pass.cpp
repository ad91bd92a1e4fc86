#include "src/render/frame/surface_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cap_alpha_test.hpp"
#include "src/render/drawing/cull_scope.hpp"
#include "src/scene/srgb.hpp"
#include "src/settings/build_parts.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/lights/light_cone.hpp"
#include "src/shadow/lights/light_range.hpp"

#include <algorithm>
#include <cstddef>

namespace edgeshade {
namespace {

struct Attribute {
    /// The buffer that holds it: SurfaceVertex or SidedVertex, or SurfaceDetail.
    enum class Buffer { vertices, details };

    const char* name;
    int components;
    unsigned type; ///< GL enum; bytes are normalised
    std::size_t offset;
    Buffer buffer;
    bool (*isOf)(const SurfaceVariant&);
};

/// In the order of their locations.
constexpr Attribute attributes[] = {
    {"a_position", 3, GL_FLOAT, offsetof(SurfaceVertex, position), Attribute::Buffer::vertices,
     [](const SurfaceVariant&) { return true; }},
    {"a_texcoord", 2, GL_FLOAT, offsetof(SurfaceVertex, texcoord), Attribute::Buffer::vertices,
     [](const SurfaceVariant& of) { return of.look.takes(0); }},
    {"a_color", 4, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, color), Attribute::Buffer::vertices,
     [](const SurfaceVariant& of) { return of.look.colored; }},
    {"a_normal", 3, GL_FLOAT, offsetof(SurfaceVertex, normal), Attribute::Buffer::vertices,
     [](const SurfaceVariant& of) {
         return of.light.from != LightArrival::From::nowhere || of.look.plain || of.look.material;
     }},
    {"a_tangent", 4, GL_FLOAT, offsetof(SurfaceDetail, tangent), Attribute::Buffer::details,
     [](const SurfaceVariant& of) { return of.look.material && of.look.material->tangents; }},
    {"a_texcoord1", 2, GL_FLOAT, offsetof(SurfaceDetail, texcoords), Attribute::Buffer::details,
     [](const SurfaceVariant& of) { return of.look.takes(1); }},
    {"a_texcoord23", 4, GL_FLOAT, offsetof(SurfaceDetail, texcoords) + sizeof(glm::vec2),
     Attribute::Buffer::details,
     [](const SurfaceVariant& of) { return of.look.takes(2) || of.look.takes(3); }},
    {"a_lightSide", 1, GL_FLOAT, offsetof(SidedVertex, lightSide), Attribute::Buffer::vertices,
     [](const SurfaceVariant& of) { return of.shadow.sided; }},
};

/// A casting chunk's triangles with their sides for a primitive map's light; null: not needed, or
/// an animation moves them.
const SidedChunk* sidedOf(const SurfaceChunk& chunk, const BatchView& view,
                          const SurfaceShading& shading) {
    return shading.primitives && !view.sided->empty() ? &(*view.sided)[chunk.place] : nullptr;
}

bool mayBeSeen(const SurfaceChunk& chunk, const BatchView& view) {
    if (isBeyond(chunk.bounds, view.light, view.range)) return false;
    return std::none_of(view.planes.begin(), view.planes.end(),
                        [&](const glm::dvec4& plane) { return isOutside(chunk.bounds, plane); });
}

/// Shading of an unlit material: its whole colour with ambient light, and black in passes that add
/// light. There it is drawn too, since only the first of coinciding surfaces is lit.
SurfaceShading unlitShading(SurfaceShading shading) {
    shading.ambient = shading.addsLight() ? 0.0f : 1.0f;
    shading.light.reset();
    shading.listed = nullptr;
    shading.withAmbient = false;
    shading.map = nullptr;
    shading.primitives = nullptr;
    shading.coarse = nullptr;
    shading.visibility = nullptr;
    return shading;
}

/// Shading of a ground that catches shadow: all lights together show the whole background, whatever
/// their colours and intensities.
SurfaceShading catcherShading(SurfaceShading shading) {
    if (shading.full) {
        shading.ambient += shading.full->ambientSlope; // of a surface that faces up
        shading.full->ambientSlope = 0.0f;
        shading.full->exposure = 1.0f;
    }
    shading.ambient = std::min(shading.ambient, 1.0f);
    shading.diffuse =
        (1.0f - shading.ambient) * static_cast<float>(shading.weight / shading.lights);
    return shading;
}

} // namespace

bool isOutOfView(const GpuBatch& batch, const ViewPlanes& planes) {
    return std::any_of(planes.begin(), planes.end(), [&](const glm::dvec4& plane) {
        const glm::dvec4 ofBatch = glm::transpose(batch.worldFromBatch) * plane;
        return std::all_of(
            batch.surfaces->begin(), batch.surfaces->end(),
            [&](const SurfaceChunk& chunk) { return isOutside(chunk.bounds, ofBatch); });
    });
}

BatchView surfaceViewOf(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                        const DepthSlice& slice, const SurfaceShading& shading) {
    BatchView result = batchViewOf(batch, view, slice);
    const auto number = static_cast<std::size_t>(&batch - scene.batches.data());
    if (shading.light && shading.light->isSpot())
        result.coneFromObject = glm::mat4(coneFromWorld(*shading.light) * batch.worldFromBatch);
    if (shading.light && shading.light->hasRange() && shading.addsLight()) {
        result.light = glm::dvec3(glm::inverse(batch.worldFromBatch) * shading.light->position);
        result.range = rangeInObject(*shading.light, batch.worldFromBatch);
    }
    if (shading.map)
        result.mapFromObject = glm::mat4(shading.map->mapFromWorld * batch.worldFromBatch);
    if (shading.primitives) {
        const glm::dmat4 mapFromObject = shading.primitives->mapFromWorld * batch.worldFromBatch;
        const glm::dvec3 origin(glm::inverse(mapFromObject)[3]);
        result.mapFromObject = glm::mat4(mapFromObject);
        result.mapOrigin = glm::vec3(origin);
        result.mapOriginRest = glm::vec3(origin - glm::dvec3(result.mapOrigin));
        result.sided = &shading.primitives->sided[number];
    }
    return result;
}

const gl::Program& SurfacePass::program(const SurfaceVariant& variant) {
    return programs_.get(variant, [&] {
        std::vector<std::string> names;
        for (const Attribute& attribute : attributes)
            if (attribute.isOf(variant)) names.push_back(attribute.name);
        const bool geometryAlone = variant.picture != SurfaceVariant::Picture::colors;
        return gl::Program(shaders::surface_vert,
                           geometryAlone           ? shaders::coarse_surface_frag
                           : variant.look.material ? shaders::material_frag
                                                   : shaders::surface_frag,
                           definesOf(variant, device_), names);
    });
}

std::size_t SurfacePass::draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                              const SurfaceShading& shading) {
    std::size_t runs = 0;
    for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            const Material& material = scene.materials[chunk.material];
            if (material.alphaMode != kind || !material.isSeen()) continue;
            const CullScope frontAlone(view.culls && !material.doubleSided, view.mirrored);
            runs += drawChunk(scene, chunk, view, shading);
        }
    return runs;
}

std::size_t SurfacePass::drawChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                                   const BatchView& view, const SurfaceShading& shading) {
    if (!mayBeSeen(chunk, view)) return 0;
    const bool shaded = !shading.mask && !shading.geometryAlone();
    if (shaded && scene.materials[chunk.material].unlit)
        return drawSeen(scene, chunk, view, unlitShading(shading));
    if (shaded && scene.materials[chunk.material].ground == GroundMaterial::catcher)
        return drawSeen(scene, chunk, view, catcherShading(shading));
    return drawSeen(scene, chunk, view, shading);
}

std::size_t SurfacePass::drawSeen(const GpuScene& scene, const SurfaceChunk& chunk,
                                  const BatchView& view, const SurfaceShading& shading) {
    const Material& material = scene.materials[chunk.material];
    const bool casts = shading.map || shading.primitives ? scene.castsInMaps(material)
                                                         : material.casts(scene.castMasked);
    const SidedChunk* sided = casts ? sidedOf(chunk, view, shading) : nullptr;
    const SurfaceVariant variant = variantOf(scene, chunk, view, sided, shading, device_);
    const gl::Program& used = program(variant);
    used.use();
    setShading(used, shading, view);
    setLookups(used, shading, view, casts, sided ? sided->lightSide : 0.0f);
    used.set("u_baseColor", variant.look.catcher ? glm::vec4(shading.background, 1.0f)
                                                 : srgbFromLinear(material.baseColorFactor));
    used.set("u_alphaCutoff", material.alphaCutoff);
    if (variant.look.material) {
        int unit = unitsOfLookups(shading);
        if (!shading.addsLight()) shading.full->environment->bind(used, unit++);
        setMaterial(used, *variant.look.material, material, scene.textures, unit);
    }
    if (view.alpha) {
        setAlphaLookup(used, *view.alpha);
        used.set("u_baseColor", glm::vec4(1.0f, 1.0f, 1.0f, view.alpha->factor));
    } else if (variant.look.texture == SurfaceLook::Texture::baseColor) {
        used.setTexture("u_texture", 0, scene.textures.of(material.baseColor()));
    }

    const bool ownVertices = variant.shadow.sided;
    const gl::Buffer& vertices = ownVertices ? sided->vertices : chunk.vertices;
    const gl::Buffer& details = ownVertices ? sided->details : chunk.details;
    const std::size_t stride = ownVertices ? sizeof(SidedVertex) : sizeof(SurfaceVertex);
    AttributeBinding binding(nullptr);
    for (const Attribute& attribute : attributes)
        if (attribute.isOf(variant)) {
            const bool detail = attribute.buffer == Attribute::Buffer::details;
            binding.add(detail ? details : vertices, attribute.components, attribute.type,
                        attribute.type == GL_UNSIGNED_BYTE, detail ? sizeof(SurfaceDetail) : stride,
                        attribute.offset, false);
        }
    return drawIndexed(ownVertices ? sided->indices : chunk.indices, chunk.indexCount);
}

} // namespace edgeshade
