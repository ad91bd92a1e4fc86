#include "src/hours/surfaces/bits_npy.hpp"

#include "src/hours/surfaces/npy_header.hpp"

namespace edgeshade::hours {

Bytes npyOf(const SurfaceRun& run) {
    const std::string header =
        npyHeaderOf(std::array{run.cells.cells.size(), bytesOfRow(run.positions.size())});
    Bytes bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), run.light.bits.begin(), run.light.bits.end());
    return bytes;
}

} // namespace edgeshade::hours
