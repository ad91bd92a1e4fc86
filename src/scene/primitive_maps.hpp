#pragma once

#include "src/policy/shadow_policy.hpp"
#include "src/scene/primitive_map_worker.hpp"

#include <string>

namespace edgeshade {

/// What became of a light's primitive map.
struct PrimitiveMapState {
    std::shared_ptr<const GpuPrimitiveMap> map; ///< null: shadows are counted by volumes
    std::string why;                            ///< a clause
    double buildMs = 0.0;                       ///< on the CPU
};

/// Whose primitive maps there are to be.
struct MapDemand {
    std::vector<Light> lights{}; ///< those whose maps matter more first
    /// So many of them, the first, get one; others keep theirs as long as there is room.
    std::size_t wanted = 0;
    ShadowPolicy policy; ///< says which of them should have one
    /// What casts is looked up, too; false: only what is see-through.
    bool castersReceive = true;
};

/// Primitive maps of a scene's lights, kept while lights rest: static casters are in them, others
/// are counted. Of a light with an extent it is one for all of it, which animated casters rule out.
/// All of them together take PrimitiveMapSettings::mostBytes at most: a map may take half of what
/// those of lights that matter more leave. A coarser one is made where that is too little, or none.
/// clear() comes before the scene goes, or static batches move.
class PrimitiveMaps {
  public:
    /// Has maps built there from now on where they are built in the background.
    void buildWith(std::shared_ptr<PrimitiveMapWorker> worker) { worker_ = std::move(worker); }

    /// Has the maps that are wanted and fit, and none of other lights, when it returns. Throws
    /// Error(unavailable) if the GL can't.
    void make(const LoadedScene& loaded, const MapDemand& demand,
              const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities);

    /// The same in the background, light after light: returns whether one has been finished. Where
    /// there are neither threads nor a worker it works for so long.
    bool advance(const LoadedScene& loaded, const MapDemand& demand,
                 const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities,
                 double milliseconds);

    /// Null: nobody has made one yet.
    const PrimitiveMapState* of(const Light& light) const;
    /// Null: there is none.
    const GpuPrimitiveMap* mapOf(const Light& light) const {
        const PrimitiveMapState* state = of(light);
        return state ? state->map.get() : nullptr;
    }

    void clear();
    std::size_t bytes() const;

  private:
    struct Kept {
        Light light;
        PrimitiveMapState state;
        /// Bytes that a map might take which wasn't to be had; infinite: more would not help.
        double room;
        bool seen;
    };

    std::vector<Kept>::const_iterator firstAt(const glm::dvec4& place) const;
    /// In `kept_`; its size: there is none.
    std::size_t placeOf(const Light& light) const;
    void keep(const Light& light, PrimitiveMapState state, double room);
    void keepOnly(const MapDemand& demand);
    /// Gives up maps of what matters less, as long as they take too much.
    void keepWhatFits(const MapDemand& demand, std::size_t mostBytes);
    /// Settles what needs no map; returns whether the light needs one, of `room` bytes at most.
    bool needsJob(const LoadedScene& loaded, const Light& light, const ShadowPolicy& policy,
                  std::size_t room);
    /// The first light's that needs a job; nothing: none does.
    std::optional<PrimitiveMapTask> nextTask(const LoadedScene& loaded, const MapDemand& demand,
                                             const PrimitiveMapSettings& settings,
                                             const gl::Capabilities& capabilities);
    /// With what the scene adds to the settings: what MASK surfaces are cut out by, if they cast.
    PrimitiveMapTask taskOf(const LoadedScene& loaded, const Light& light,
                            PrimitiveMapSettings settings, const gl::Capabilities& capabilities);
    void take(const BuiltPrimitiveMap& built, std::size_t batches, const MapDemand& demand,
              const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities);
    void giveUp();

    std::vector<Kept> kept_; ///< by place
    bool castersReceive_ = true;
    KeptEdges edges_;
    CutoutTextures textures_;                     ///< once they were asked for
    std::shared_ptr<const AlphaTexture> cutouts_; ///< the atlas on the GPU
    std::unique_ptr<PrimitiveMapJob> job_;        ///< in the background
    std::shared_ptr<PrimitiveMapWorker> worker_;  ///< null: there is none
    std::optional<Light> asked_;                  ///< whose map it builds
};

/// Places of a light that one pass counts by its map.
inline constexpr std::size_t placesAtOnce = 16;

} // namespace edgeshade
