#pragma once

#include "src/policy/shadow_policy.hpp"
#include "src/scene/primitive_map_worker.hpp"

#include <string>

namespace edgeshade {

/// State of a light's primitive map.
struct PrimitiveMapState {
    std::shared_ptr<const GpuPrimitiveMap> map; ///< null: shadows are counted by volumes
    std::string why;                            ///< a clause
    double buildMs = 0.0;                       ///< on the CPU
};

/// The lights that get or keep primitive maps.
struct MapDemand {
    std::vector<Light> lights{}; ///< those whose maps matter more come first
    /// The first so many get one; others keep theirs as long as there is room.
    std::size_t wanted = 0;
    ShadowPolicy policy; ///< decides which of them should have one
    /// Casters are receivers too; false: only see-through surfaces are.
    bool castersReceive = true;
};

/// Primitive maps of a scene's lights, kept while lights rest. Static casters are in them, other
/// casters are counted by volumes. A light with an extent has one map for all of it, which animated
/// casters rule out. Together they take at most PrimitiveMapSettings::mostBytes. A map may take
/// half of what the maps of more important lights leave. If that is too little, a coarser map is
/// made, or none. Call clear() before the scene is destroyed or static batches move.
class PrimitiveMaps {
  public:
    /// From now on `worker` builds the maps of advance().
    void buildWith(std::shared_ptr<PrimitiveMapWorker> worker) { worker_ = std::move(worker); }

    /// Builds the wanted maps that fit before it returns, and deletes those of other lights. Throws
    /// Error(unavailable) if the GL can't.
    void make(const LoadedScene& loaded, const MapDemand& demand,
              const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities);

    /// Does the same in the background, light after light. Returns whether a map was finished.
    /// Without threads or a worker it works for `milliseconds`.
    bool advance(const LoadedScene& loaded, const MapDemand& demand,
                 const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities,
                 double milliseconds);

    /// Null if no map was tried yet.
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
        /// Bytes that were allowed and not enough; infinite: more would not help.
        double room;
        bool seen;
    };

    std::vector<Kept>::const_iterator firstAt(const glm::dvec4& place) const;
    /// Index in `kept_`; its size if there is none.
    std::size_t placeOf(const Light& light) const;
    void keep(const Light& light, PrimitiveMapState state, double room);
    void keepOnly(const MapDemand& demand);
    /// Deletes maps of less important lights until the rest fits.
    void keepWhatFits(const MapDemand& demand, std::size_t mostBytes);
    /// Settles lights that need no map; returns whether this one needs one, of at most `room`
    /// bytes.
    bool needsJob(const LoadedScene& loaded, const Light& light, const ShadowPolicy& policy,
                  std::size_t room);
    /// The task of the first light that needs a job; null if none does.
    std::optional<PrimitiveMapTask> nextTask(const LoadedScene& loaded, const MapDemand& demand,
                                             const PrimitiveMapSettings& settings,
                                             const gl::Capabilities& capabilities);
    /// A task with the settings that depend on the scene, as the textures that cut out casting MASK
    /// surfaces.
    PrimitiveMapTask taskOf(const LoadedScene& loaded, const Light& light,
                            PrimitiveMapSettings settings, const gl::Capabilities& capabilities);
    void take(const BuiltPrimitiveMap& built, std::size_t batches, const MapDemand& demand,
              const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities);
    void giveUp();

    std::vector<Kept> kept_; ///< sorted by the light's position
    bool castersReceive_ = true;
    KeptEdges edges_;
    CutoutTextures textures_;                     ///< set once a map needed them
    std::shared_ptr<const AlphaTexture> cutouts_; ///< the atlas on the GPU
    std::unique_ptr<PrimitiveMapJob> job_;        ///< runs in the background
    std::shared_ptr<PrimitiveMapWorker> worker_;  ///< null: none
    std::optional<Light> asked_;                  ///< the light whose map the worker builds
};

} // namespace edgeshade
