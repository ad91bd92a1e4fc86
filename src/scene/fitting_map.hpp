#pragma once

#include "src/shadow/primitive_map/primitive_map_builder.hpp"

#include <memory>

namespace edgeshade {

/// Longest list with which a map is used. GLs may end a loop after a number of iterations, and
/// light would leak: Mesa's llvmpipe did at 5,699 iterations and not at 4,754, softpipe never.
inline constexpr std::size_t longestAsked = 3072;

/// A light's primitive map, at a size that fits. It starts with as many texels as suit its casters,
/// within its settings. If it takes too much memory, half as many along an edge are tried, down to
/// an eighth. If a list is longer than longestAsked or its settings want, it gives up at once:
/// larger texels have longer lists.
class FittingMap {
  public:
    FittingMap(const Light& light, std::vector<PlacedCasters> casters,
               const PrimitiveMapSettings& settings);

    /// Builds one part. Returns whether parts remain.
    bool step();
    /// Builds all parts at the size being tried, on as many threads as there are cores.
    void buildAllParts();

    /// Valid once all parts are built.
    bool tooFar() const { return tooFar_; }
    /// Length of the list that was too long, or 0.
    std::size_t tooLong() const { return tooLong_; }
    std::optional<PrimitiveMap>& map() { return map_; }

  private:
    Light light_;
    std::vector<PlacedCasters> casters_;
    PrimitiveMapSettings settings_;
    int smallest_ = 0; ///< smallest size to try
    std::unique_ptr<PrimitiveMapBuilder> builder_;
    std::size_t nextPart_ = 0;
    bool joined_ = false, tooFar_ = false;
    std::size_t tooLong_ = 0;
    std::optional<PrimitiveMap> map_;
};

/// Outcome of building a map.
struct MapOutcome {
    bool built = false, tooFar = false;
    std::size_t tooLong = 0;   ///< FittingMap::tooLong()
    std::size_t mostBytes = 0; ///< the map's memory limit
};

/// Why the map can't be used, a clause; empty if it can.
std::string refusalOf(const MapOutcome& outcome);

} // namespace edgeshade
