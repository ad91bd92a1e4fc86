#pragma once

#include "src/shadow/layers/layer_search.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// Bounds the layers around lights, and keeps the bounds of lights at rest: one takes about 1 ms
/// for 150,000 triangles, and some ten times as long where groups are needed. Lights that aren't
/// drawn, or have no shadow, or whose static casters aren't counted, are skipped.
class KeptLayers {
  public:
    explicit KeptLayers(std::shared_ptr<KeptChains> chains = std::make_shared<KeptChains>())
        : search_(std::move(chains)) {}

    /// Fills in FrameLight::layers; those of lights that have not moved since the last call are
    /// reused. The casters must be unchanged since then; otherwise call clear() first. Returns
    /// false if all were known. `visible`: FrameView::visible. A light that has moved gets a bound
    /// for it alone, and a bound for everything once it rests and the eye moves.
    bool fill(const LayerCasters& casters, std::vector<FrameLight>& lights, const Box& visible);
    /// The same for a light whose other casters a host looks up: `casters` are those that count.
    bool fillMovers(const LayerCasters& casters, FrameLight& light, const Box& visible);

    /// Takes a step of what fill() or fillMovers() of the same takes for a light. Returns whether
    /// no step is left but that call.
    bool lookAhead(const LayerCasters& casters, const FrameLight& light, const Box& visible);

    void clear() { kept_.clear(); }

  private:
    struct Kept {
        glm::dvec4 light; ///< its position
        double range;
        std::optional<LightExtent> extent;
        std::size_t points = 0;
        Box receivers; ///< for which the bound holds; empty: everywhere
        LayerBound layers;

        bool holdsFor(const Box& visible) const;
    };

    /// The bound of a light that has not moved; the end if there is none.
    std::vector<Kept>::const_iterator keptOf(const FrameLight& light) const;
    /// The receivers for which a light's bound has to be found; null if it needn't be. `found`: its
    /// keptOf().
    std::optional<Box> unknownFor(const FrameLight& light, std::vector<Kept>::const_iterator found,
                                  const Box& visible) const;
    /// Whether a light's bound was known. Puts it into next_.
    bool fillOne(const LayerCasters& casters, FrameLight& light, const Box& visible);

    std::vector<Kept> kept_, next_; ///< fill() makes `next_`, in the memory of the call before
    LayerSearch search_;
};

} // namespace edgeshade
