#pragma once

#include "edgeshade/shadow_masks.hpp"

#include <algorithm>

namespace edgeshade::web {

/// Numbers that JavaScript has put at an address of the program's memory.
template <class T>
const T* at(std::uintptr_t address) {
    return reinterpret_cast<const T*>(address);
}

inline Matrix16 matrixAt(std::uintptr_t address) {
    Matrix16 matrix{};
    std::copy_n(at<double>(address), matrix.size(), matrix.begin());
    return matrix;
}

/// `flags`, from the lowest bit: casts, double-sided, bends, alpha-tested, visible.
inline MaskMesh meshAt(std::uintptr_t positions, std::size_t floats, std::uintptr_t indices,
                       std::size_t count, std::uintptr_t texcoords, std::size_t texcoordFloats,
                       unsigned flags) {
    return {.positions = {at<float>(positions), floats},
            .indices = {at<std::uint32_t>(indices), count},
            .casts = (flags & 1u) != 0,
            .doubleSided = (flags & 2u) != 0,
            .bends = (flags & 4u) != 0,
            .alphaTested = (flags & 8u) != 0,
            .texcoords = {at<float>(texcoords), texcoordFloats},
            .visible = (flags & 16u) != 0};
}

} // namespace edgeshade::web
