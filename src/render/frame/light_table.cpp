#include "src/render/frame/light_table.hpp"

#include "src/render/frame/cone_window.hpp"
#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>
#include <bit>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr std::size_t texelsOfALight = 4;

/// Least number of turns of the shader's loop. It is far more than most lists need: a software GL,
/// which shades pixels in lockstep, would unroll a shorter loop.
constexpr std::size_t leastTurns = 64;

void addLight(const Light& light, const glm::vec3& color, const glm::dvec3& eye,
              std::vector<glm::vec4>& texels) {
    const bool directional = light.position.w == 0.0;
    const glm::dvec3 place(light.position);
    glm::vec4 where(directional ? unitOf(place) : place / light.position.w - eye, 0.0f);
    if (!directional) where.w = (light.photometric ? 2.0f : 1.0f) + (light.isSpot() ? 2.0f : 0.0f);
    glm::vec4 spot(0.0f), scale(0.0f);
    if (light.isSpot()) {
        const ConeWindow window(*light.cone);
        spot = glm::vec4(glm::vec3(light.cone->axis), window.inverseOuter);
        scale.x = window.scale;
    }
    texels.insert(
        texels.end(),
        {where, glm::vec4(color, light.hasRange() ? static_cast<float>(1.0 / light.range) : 0.0f),
         spot, scale});
}

} // namespace

bool LightTable::isPossible(const gl::Capabilities& capabilities) {
    return gl::hasWideTables(capabilities) && capabilities.textureUnits >= 2;
}

LightTableLookup LightTable::upload(const LightLists& lists, const FrameView& view,
                                    const std::function<glm::vec3(std::size_t)>& colorOf) {
    std::vector<glm::vec4> texels;
    for (const LightLists::Range& range : lists.ofTile)
        texels.emplace_back(static_cast<float>(range.first), static_cast<float>(range.count), 0.0f,
                            0.0f);
    const std::size_t firstEntry = texels.size();
    texels.resize(firstEntry + (lists.entries.size() + 3) / 4, glm::vec4(0.0f));
    for (std::size_t i = 0; i < lists.entries.size(); ++i)
        texels[firstEntry + i / 4][static_cast<glm::length_t>(i % 4)] =
            static_cast<float>(lists.entries[i]);
    const std::size_t firstLight = texels.size();
    for (const std::size_t light : lists.lights)
        addLight(view.lights[light].light, colorOf(light), view.frustum.position(), texels);
    static_assert(texelsOfALight == 4);

    glActiveTexture(GL_TEXTURE0);
    if (!table_ || texels_ < texels.size()) {
        texels_ = std::bit_ceil(texels.size());
        table_.emplace(texels_, capabilities_);
    }
    table_->fill(0, texels);
    LightTableLookup lookup;
    lookup.texture = table_->texture();
    lookup.size = table_->size();
    lookup.tiles = {static_cast<float>(lists.columns), 1.0f / LightLists::tile,
                    static_cast<float>(firstEntry), static_cast<float>(firstLight)};
    lookup.longest = static_cast<int>(std::bit_ceil(std::max(lists.longest, leastTurns)));
    return lookup;
}

void setLightTable(const gl::Program& program, const LightTableLookup& table, int unit) {
    program.setTexture("u_lightTable", unit, table.texture);
    program.set("u_lightTableSize", table.size);
    program.set("u_lightTiles", table.tiles);
}

} // namespace edgeshade
