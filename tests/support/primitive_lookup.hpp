#pragma once

// The shader's own lookup (primitive_map_lookup.glsl), compiled as C++ over a PrimitiveMap.

#include "src/shadow/primitive_map/primitive_map.hpp"
#include "tests/support/primitive_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace edgeshade::test::lookup_arithmetic {

using glm::abs;
using glm::clamp;
using glm::floor;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using std::max;

/// A texture of floats with this many columns.
struct Table {
    std::vector<vec4> texels;
    int columns = 256, rows = 1;

    Table() = default;
    /// `count` pairs, two to each texel.
    Table(std::span<const vec4> pairs, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const vec2 pair = pairAt(pairs, i);
            texels.emplace_back(pair.x, pair.x, pair.x, pair.y); // luminance and alpha
        }
        fit();
    }
    explicit Table(std::span<const vec4> whole) : texels(whole.begin(), whole.end()) { fit(); }
    void fit() { rows = static_cast<int>(texels.size()) / columns + 1; }
    vec3 size() const {
        return {columns, 1.0f / static_cast<float>(columns), 1.0f / static_cast<float>(rows)};
    }
};

using sampler2D = const Table*;

inline vec4 texture2D(sampler2D table, const vec2& at) {
    const auto x = static_cast<std::size_t>(at.x * static_cast<float>(table->columns));
    const auto y = static_cast<std::size_t>(at.y * static_cast<float>(table->rows));
    return table->texels.at(y * static_cast<std::size_t>(table->columns) + x);
}

// The shader's literals are doubles here; the results are still rounded to floats.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define uniform
#define highp
#define PRIMITIVE_MAP_LONGEST 1000000
struct OneTile {
#include "shaders_es2/primitive_map_lookup.glsl"
};
#define PRIMITIVE_MAP_TILES
struct SixTiles {
#include "shaders_es2/primitive_map_lookup.glsl"
};
#undef PRIMITIVE_MAP_TILES
#define PRIMITIVE_MAP_DIRECTIONAL
struct Directional {
#include "shaders_es2/primitive_map_lookup.glsl"
};
#undef PRIMITIVE_MAP_DIRECTIONAL
#undef PRIMITIVE_MAP_LONGEST
#undef highp
#undef uniform
#pragma GCC diagnostic pop

} // namespace edgeshade::test::lookup_arithmetic

namespace edgeshade::test {

/// Queries a map as the shader does, in floats.
class PrimitiveLookup {
  public:
    explicit PrimitiveLookup(const PrimitiveMap& map)
        : map_(map), header_(map.texels, map.headers),
          entries_(std::span(map.texels).subspan(map.entriesBegin()), map.entries),
          records_(std::span(map.texels).subspan(map.recordsBegin())) {}

    bool lights(const glm::dvec3& world, bool casts) const {
        const glm::vec3 point(map_.tiles.mapFromWorld * glm::dvec4(world, 1.0));
        if (map_.tiles.directional) return ask<lookup_arithmetic::Directional>(point, casts);
        if (map_.tiles.tiles.size() == 1) return ask<lookup_arithmetic::OneTile>(point, casts);
        return ask<lookup_arithmetic::SixTiles>(point, casts);
    }

  private:
    template <class Shader>
    bool ask(const glm::vec3& point, bool casts) const {
        Shader shader;
        shader.u_primitiveHeader = &header_;
        shader.u_primitiveEntries = &entries_;
        shader.u_primitiveRecords = &records_;
        shader.u_primitiveHeaderSize = header_.size();
        shader.u_primitiveEntriesSize = entries_.size();
        shader.u_primitiveRecordsSize = records_.size();
        shader.u_primitiveSize = static_cast<float>(map_.size);
        shader.primitiveMoved = 0.0f;
        shader.primitiveReach = 1.0f;
        return shader.primitiveMapLights(point, casts);
    }

    const PrimitiveMap& map_;
    lookup_arithmetic::Table header_, entries_, records_;
};

} // namespace edgeshade::test
