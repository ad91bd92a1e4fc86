#include "src/hours/surfaces/bits_npy.hpp"

namespace edgeshade::hours {
namespace {

/// Data begin at a multiple of this (NumPy's format 1.0).
constexpr std::size_t alignment = 64;

} // namespace

Bytes npyOf(const SurfaceRun& run) {
    std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (" +
                         std::to_string(run.cells.cells.size()) + ", " +
                         std::to_string(bytesOfRow(run.positions.size())) + "), }";
    constexpr std::string_view magic("\x93NUMPY\x01\x00", 8);
    while ((magic.size() + 2 + header.size() + 1) % alignment != 0)
        header += ' ';
    header += '\n';
    Bytes bytes(magic.begin(), magic.end());
    bytes.push_back(static_cast<std::uint8_t>(header.size() & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(header.size() >> 8));
    bytes.insert(bytes.end(), header.begin(), header.end());
    bytes.insert(bytes.end(), run.light.bits.begin(), run.light.bits.end());
    return bytes;
}

} // namespace edgeshade::hours
