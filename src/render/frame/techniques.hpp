#pragma once

#include "src/policy/shadow_policy.hpp"
#include "src/render/shadow_map/map_technique.hpp"
#include "src/render/volumes/volumes_technique.hpp"

#include <array>
#include <memory>

namespace edgeshade {

/// The techniques that a renderer's settings allow.
class Techniques {
  public:
    /// Throws Error(unavailable) if the GL can't do what the user requested by name, or this build
    /// lacks it.
    Techniques(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Null: no light can have it, or it is Technique::none.
    ShadowTechnique* of(Technique technique) const {
        return all_[static_cast<std::size_t>(technique)].get();
    }

    template <class Use>
    void forEach(Use use) const {
        for (const auto& technique : all_)
            if (technique) use(*technique);
    }

    /// See ShadowTechnique.
    void prepareScene(const GpuScene& scene, const LoadedScene& loaded) const {
        forEach([&](ShadowTechnique& of) { of.prepareScene(scene, loaded); });
    }

    /// Whether some technique answers yes.
    bool any(bool (ShadowTechnique::*question)() const) const {
        bool answer = false;
        forEach([&](const ShadowTechnique& of) { answer = answer || (of.*question)(); });
        return answer;
    }

    std::size_t bytes() const {
        std::size_t total = 0;
        forEach([&](const ShadowTechnique& of) { total += of.bytes(); });
        return total;
    }

    /// Memory of shadow maps and planes.
    std::size_t mapBytes() const {
        std::size_t total = 0;
        for (const Technique technique : {Technique::map, Technique::planar})
            if (const ShadowTechnique* made = of(technique)) total += made->bytes();
        return total;
    }

    /// Null if no shadows can be volumes.
    const VolumesTechnique* volumes() const {
        return static_cast<const VolumesTechnique*>(of(Technique::volumes));
    }
    /// Null if shadows are not maps.
    MapTechnique* map() const { return static_cast<MapTechnique*>(of(Technique::map)); }

  private:
    static constexpr std::size_t count = 6; ///< number of values of Technique
    std::array<std::unique_ptr<ShadowTechnique>, count> all_{};
};

} // namespace edgeshade
