#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

#include <string>
#include <tuple>

namespace edgeshade {

/// What one pass over a surface asks of material.frag: what the material has and the pass can show.
/// A variant of the shader is compiled for each.
struct MaterialFeatures {
    std::array<signed char, textureSlots> channels{}; ///< of each texture's coordinates; -1: none
    bool glossy = false;                              ///< specular-glossiness
    bool emissive = false;                            ///< gives off light
    bool clearcoat = false;                           ///< has a coat
    bool tangents = false;                            ///< of its vertices
    bool ambient = false;                             ///< light from everywhere is shown

    auto key() const { return std::tie(channels, glossy, emissive, clearcoat, tangents, ambient); }
    bool operator<(const MaterialFeatures& other) const { return key() < other.key(); }

    bool has(TextureSlot slot) const { return channels[static_cast<std::size_t>(slot)] >= 0; }
    /// Whether some texture, or the base colour's for channel 0, takes these coordinates.
    bool takes(int channel) const;
};

/// `textureUnits`: how many it may take. Where it wants more, the last of its textures in the order
/// of TextureSlot are left out; so are normals by texture without tangents and derivatives.
MaterialFeatures featuresOf(const GpuScene& scene, const SurfaceChunk& chunk, bool ambient,
                            bool derivatives, int textureUnits);

/// The #defines of its variant.
void addDefines(const MaterialFeatures& features, std::vector<std::string>& defines);

/// Sets what the variant reads of the material; textures get the units from `firstUnit` on.
void setMaterial(gl::Program& program, const MaterialFeatures& features, const Material& material,
                 const Textures& textures, int firstUnit);

} // namespace edgeshade
