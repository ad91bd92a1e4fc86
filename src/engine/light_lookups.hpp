#pragma once

#include "src/engine/lookup_work.hpp"
#include "src/gl/float_table.hpp"

#include <map>
#include <span>
#include <utility>

namespace edgeshade {

/// Primitive maps of resting lights on the GPU, for hosts to look up.
class LightLookups {
  public:
    using Id = std::uint32_t;

    explicit LightLookups(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Why no light can have a map: a clause, or empty.
    std::string obstacle() const;

    /// Takes the map out of finished work, and makes a texture that is still empty. Throws
    /// InputError if the work isn't done, or its map was taken before.
    Id add(const LookupWork& work);
    /// Uploads up to `mostBytes`; returns whether all is uploaded.
    bool upload(Id id, std::size_t mostBytes);
    void remove(Id id);

    const LightLookup& told(Id id) const { return at(id).told; }
    /// The casters in the map.
    std::span<const HeldCaster> held(Id id) const { return at(id).held; }
    /// Whether the map is of this light, except for properties that shadows don't depend on.
    bool isOf(Id id, const Light& light) const;
    /// Whether the map is right for receivers in a box in the world. The disc of a sun shades
    /// points that are farther off by more casters.
    bool reaches(Id id, const Box& receivers) const;
    std::size_t bytes() const;

  private:
    struct Kept {
        Light light;
        Box receivers;
        std::vector<HeldCaster> held;
        std::vector<glm::vec4> texels; ///< until they are uploaded
        gl::FloatTable table;
        std::size_t uploaded = 0; ///< texels
        LightLookup told;
    };

    const Kept& at(Id id) const;
    Kept& at(Id id) { return const_cast<Kept&>(std::as_const(*this).at(id)); }

    gl::Capabilities capabilities_;
    std::map<Id, Kept> kept_;
    Id next_ = 0;
};

} // namespace edgeshade
