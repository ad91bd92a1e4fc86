#pragma once

#include "src/hours/surfaces/cell_arrays.hpp"
#include "src/hours/surfaces/surface_part.hpp"

#include <functional>

namespace edgeshade::hours {

/// Joins the parts of a run over surfaces, one after the other, in any order. Cells are kept once,
/// and of further parts only their light.
class SurfaceMerge {
  public:
    /// `path`: of the part's file, for messages. Throws InputError naming file, field and value if
    /// it isn't of the first one's run.
    void add(const std::string& path, SurfacePart part);

    /// The number of cells, and of the run's positions.
    std::size_t cells() const { return first_.run.cells.cells.size(); }
    std::size_t positions() const { return first_.positionsOfRun; }

    /// The run as if it had not been split, with its scene. `bits`: whether it keeps them.
    /// `onShare` is called with the share that is done. Throws InputError for a part that is
    /// repeated or missing.
    SurfacePart whole(bool bits, const std::function<void(double)>& onShare) &&;

  private:
    /// The light of a part.
    struct Light {
        std::vector<Position> positions;
        std::vector<std::uint8_t> bits;
    };

    rays::LitBits bitsOf(std::span<const std::size_t> order, std::size_t first,
                         std::size_t end) const;

    SurfacePart first_; ///< without positions and bits
    CellArrays arrays_; ///< of first_
    std::vector<std::string> paths_;
    std::vector<std::size_t> numbers_;
    std::vector<Light> lights_; ///< in the order of paths_
};

} // namespace edgeshade::hours
