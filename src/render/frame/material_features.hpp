#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

#include <compare>
#include <string>

namespace edgeshade {

/// The features of material.frag that one pass over a surface needs: those that the material has
/// and the pass can show. Each combination is a variant of the shader.
struct MaterialFeatures {
    std::array<signed char, textureSlots> channels{}; ///< coordinate set of each texture; -1: no
                                                      ///< texture
    bool glossy = false;                              ///< specular-glossiness
    bool clearcoat = false;                           ///< has a clearcoat
    bool tangents = false;                            ///< the vertices have tangents
    bool ambient = false;                             ///< ambient light is shown

    std::strong_ordering operator<=>(const MaterialFeatures&) const = default;

    bool has(TextureSlot slot) const { return channels[static_cast<std::size_t>(slot)] >= 0; }
    /// Whether any texture uses this set of coordinates; channel 0 is also the base colour's.
    bool takes(int channel) const;
};

/// `textureUnits`: number available. If the material needs more, the last textures in the order of
/// TextureSlot are left out. Normal maps are left out if there are neither tangents nor
/// derivatives.
MaterialFeatures featuresOf(const GpuScene& scene, const SurfaceChunk& chunk, bool ambient,
                            bool derivatives, int textureUnits);

/// Appends the variant's #defines.
void addDefines(const MaterialFeatures& features, std::vector<std::string>& defines);

/// Sets the variant's uniforms; textures take the units from `firstUnit` on.
void setMaterial(const gl::Program& program, const MaterialFeatures& features,
                 const Material& material, const Textures& textures, int firstUnit);

} // namespace edgeshade
