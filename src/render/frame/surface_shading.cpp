#include "src/render/frame/surface_shading.hpp"

#include "src/render/frame/cone_window.hpp"
#include "src/settings/build_parts.hpp"
#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>
#include <array>

namespace edgeshade {
namespace {

void setPcss(const gl::Program& program, const PcssLight& light) {
    program.set("u_lightRadius", light.radius);
    program.set("u_lightAcross", light.across);
    program.set("u_lightUp", light.up);
    program.set("u_lightFacing", light.facing);
    program.set("u_leastSpread", light.leastSpread);
    program.set("u_nearestCaster", light.nearestCaster);
}

void setMap(const gl::Program& program, const ShadowMapLookup& map, const BatchView& view) {
    constexpr const char* faces[] = {"u_face0", "u_face1", "u_face2",
                                     "u_face3", "u_face4", "u_face5"};
    if (map.faces == 0) program.setCube("u_map", 1, map.textures[0]);
    for (int face = 0; face < map.faces; ++face)
        program.setTexture(faces[face], 1 + face, map.textures[static_cast<std::size_t>(face)]);
    program.set("u_mapFromObject", view.mapFromObject);
    program.set("u_mapFromWorld", glm::mat3(map.mapFromWorld));
    program.set("u_mapStep", map.step);
    program.set("u_mapTexel", map.texel);
    program.set("u_mapBias", map.biasTexels);
    program.set("u_mapShare", map.share);
    program.set("u_mapScale", map.mapScale);
    if (map.cascadeCount > 0) {
        program.set("u_cascades[0]",
                    std::span<const glm::vec4>(map.cascades).first(map.cascadeCount));
        program.set("u_cascadeMargin", map.cascadeMargin);
    }
    if (map.further) map.further->set(program, 1 + std::max(map.faces, 1));
    if (map.pcss) setPcss(program, *map.pcss);
}

void setPrimitiveMap(const gl::Program& program, const GpuPrimitiveMap& map, const BatchView& view,
                     float lightSide) {
    const auto bind = [&](int unit, const gl::FloatTable& table, const char* sampler,
                          const char* size) {
        program.setTexture(sampler, unit, table.texture());
        program.set(size, table.size());
    };
    bind(1, map.header, "u_primitiveHeader", "u_primitiveHeaderSize");
    bind(2, map.entries, "u_primitiveEntries", "u_primitiveEntriesSize");
    bind(3, map.records, "u_primitiveRecords", "u_primitiveRecordsSize");
    program.set("u_primitiveSize", map.size);
    program.set("u_mapHand", glm::determinant(glm::dmat3(map.mapFromWorld)) < 0.0 ? -1.0f : 1.0f);
    if (map.cutouts) {
        program.setTexture("u_primitiveAlpha", 4, map.cutouts->texture.name());
        program.set("u_primitiveAlphaTexel", 1.0f / map.cutouts->size);
    }
    program.set("u_lightSide", lightSide);
    program.set("u_mapFromObject", view.mapFromObject);
    program.set("u_mapOrigin", view.mapOrigin);
    program.set("u_mapOriginRest", view.mapOriginRest);
}

/// Sets the light's points, see shaders_es2/primitive_map_points.glsl.
void setPlaces(const gl::Program& program, const GpuPrimitiveMap& map,
               const SurfaceShading& shading) {
    std::array<std::array<glm::vec4, placesAtOnce / 4>, 4> places{}; // x, y, z, counted
    for (std::size_t i = 0; i < shading.places.size(); ++i) {
        const glm::dvec4 place = map.mapFromWorld * shading.places[i].position;
        const auto four = static_cast<glm::length_t>(i % 4);
        for (glm::length_t axis = 0; axis < 3; ++axis)
            places[static_cast<std::size_t>(axis)][i / 4][four] = static_cast<float>(place[axis]);
        places[3][i / 4][four] = 1.0f;
    }
    program.set("u_placesX[0]", std::span<const glm::vec4>(places[0]));
    program.set("u_placesY[0]", std::span<const glm::vec4>(places[1]));
    program.set("u_placesZ[0]", std::span<const glm::vec4>(places[2]));
    program.set("u_placesCounted[0]", std::span<const glm::vec4>(places[3]));
    program.set("u_placesW", static_cast<float>(shading.places.front().position.w));
    program.set("u_mapEye", glm::vec4(map.mapFromWorld * shading.eye));
}

void setPlaneSpace(const gl::Program& program, const PlaneSpace& space) {
    program.set("u_tangents", space.tangents);
    program.set("u_middle", space.middle);
    program.set("u_focal", space.focal);
    if (space.depthRange)
        program.set("u_depthRange", *space.depthRange);
    else
        program.set("u_near", space.near);
}

void setCoarseMask(const gl::Program& program, const CoarseMaskLookup& mask) {
    program.setTexture("u_coarseSurface", 1, mask.surface);
    program.setTexture("u_coarseLit", 2, mask.lit);
    setPlaneSpace(program, mask.space);
    program.set("u_coarseSize", mask.size);
    program.set("u_coarseTexel", mask.texel);
    program.set("u_coarseSlack", mask.slack);
    program.set("u_coarseLight", mask.light);
}

void setVisibility(const gl::Program& program, const VisibilityLookup& visibility) {
    program.setTexture("u_visibility", 1, visibility.texture);
    program.set("u_visibilityTexel", 1.0f / visibility.size);
}

void setLight(const gl::Program& program, const Light& light, const BatchView& view) {
    const glm::dvec4& place = light.position;
    if (place.w == 0.0) {
        program.set("u_towardsLight", glm::vec3(unitOf(glm::dvec3(place))));
        return;
    }
    program.set("u_light", glm::vec3(glm::dvec3(place) / place.w - view.eye));
    program.set("u_inverseRange", static_cast<float>(1.0 / light.range));
    if (!light.cone) return;
    const ConeWindow window(*light.cone);
    program.set("u_inverseOuter", window.inverseOuter);
    program.set("u_coneScale", window.scale);
    program.set("u_coneFromObject", view.coneFromObject);
}

} // namespace

int unitsOfLookups(const SurfaceShading& shading) {
    if (shading.map) return 1 + shading.map->units();
    if (shading.primitives) return shading.primitives->cutouts ? 5 : 4;
    if (shading.visibility || shading.listed) return 2;
    return shading.coarse ? 3 : 1;
}

void setShading(const gl::Program& program, const SurfaceShading& shading, const BatchView& view) {
    program.set("u_clipFromObject", view.clipFromObject);
    program.set("u_eyeOffsetFromObject", view.eyeOffsetFromObject);
    program.set("u_normalFromObject", view.normalFromObject);
    program.set("u_mirrored", view.mirrored ? -1.0f : 1.0f);
    program.set("u_maskValue", shading.maskValue);
    program.set("u_farthest", shading.farthest);
    program.set("u_ambient", shading.ambient);
    program.set("u_diffuse", shading.diffuse);
    if (shading.light) setLight(program, *shading.light, view);
    if (!shading.full) return;
    program.set("u_ambientSlope", shading.full->ambientSlope);
    program.set("u_exposure", shading.full->exposure);
    program.set("u_lightColor", shading.full->lightColor);
    program.set("u_eye", shading.full->eye);
}

void setLookups(const gl::Program& program, const SurfaceShading& shading, const BatchView& view,
                bool casts, float lightSide) {
    program.set("u_casts", casts ? 1.0f : 0.0f);
    if (shading.map) setMap(program, *shading.map, view);
    if (shading.primitives) setPrimitiveMap(program, *shading.primitives, view, lightSide);
    if (!shading.places.empty()) setPlaces(program, *shading.primitives, shading);
    if (shading.coarse) setCoarseMask(program, *shading.coarse);
    if (shading.visibility) setVisibility(program, *shading.visibility);
    if constexpr (listsLights)
        if (shading.listed) setLightTable(program, *shading.listed, 1);
    if (shading.geometryAlone()) setPlaneSpace(program, *shading.geometryAlone());
}

} // namespace edgeshade
