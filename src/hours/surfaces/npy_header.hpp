#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace edgeshade::hours {

/// The header of a NumPy file (format 1.0) of an array of bytes in C's order: its data follow.
/// `shape`: at least one number.
inline std::string npyHeaderOf(std::span<const std::size_t> shape) {
    constexpr std::size_t alignment = 64; // where data begin
    const std::string magic("\x93NUMPY\x01\x00", 8);
    std::string text = "{'descr': '|u1', 'fortran_order': False, 'shape': (";
    for (std::size_t i = 0; i < shape.size(); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
    text += "), }";
    while ((magic.size() + 2 + text.size() + 1) % alignment != 0)
        text += ' ';
    text += '\n';
    return magic + static_cast<char>(text.size() & 0xFF) + static_cast<char>(text.size() >> 8) +
           text;
}

} // namespace edgeshade::hours
