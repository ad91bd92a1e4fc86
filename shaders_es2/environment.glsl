// Light from all around (Environment in src/environment/environment.hpp). Radiance is linear;
// directions and normals have unit length, in the world's axes.
#include "environment_layout.glsl"

uniform mediump sampler2D u_environment; // lowp, the default, might lose the last bit of a byte
uniform float u_environmentRoot;              // the square root of the largest radiance in it
uniform vec3 u_environmentSh[9];

// Light that a white Lambert surface reflects: irradiance / pi.
vec3 environmentDiffuse(vec3 normal) {
    float x = normal.x, y = normal.y, z = normal.z;
    vec3 sum = u_environmentSh[0];
    sum += u_environmentSh[1] * y + u_environmentSh[2] * z + u_environmentSh[3] * x;
    sum += u_environmentSh[4] * (x * y) + u_environmentSh[5] * (y * z);
    sum += u_environmentSh[6] * (3.0 * z * z - 1.0);
    sum += u_environmentSh[7] * (x * z) + u_environmentSh[8] * (x * x - y * y);
    return max(sum, vec3(0.0));
}

// Place of a direction on the map, within [-1, 1]; +Y is the middle, -Y the corners.
vec2 octahedralFromDirection(vec3 direction) {
    vec3 size = abs(direction);
    vec2 at = direction.xz / (size.x + size.y + size.z);
    if (direction.y >= 0.0) return at;
    vec2 side = vec2(at.x >= 0.0 ? 1.0 : -1.0, at.y >= 0.0 ? 1.0 : -1.0);
    return (vec2(1.0) - abs(at.yx)) * side;
}

// A level's tile: its first texel, and its size including the border.
vec3 environmentTile(float level) {
    if (level < 0.5) return vec3(0.0, 0.0, ENVIRONMENT_MIRROR_TILE);
    if (level < 2.5)
        return vec3(ENVIRONMENT_MIRROR_TILE + ENVIRONMENT_GLOSSY_TILE * (level - 1.0), 0.0,
                    ENVIRONMENT_GLOSSY_TILE);
    return vec3(ENVIRONMENT_MIRROR_TILE + ENVIRONMENT_ROUGH_TILE * (level - 3.0),
                ENVIRONMENT_GLOSSY_TILE, ENVIRONMENT_ROUGH_TILE);
}

vec3 environmentLevel(vec2 at, float level) {
    vec3 tile = environmentTile(level);
    vec2 texel = tile.xy + vec2(1.0) + (at * 0.5 + vec2(0.5)) * (tile.z - 2.0);
    vec4 stored = texture2D(u_environment, texel / vec2(ENVIRONMENT_WIDTH, ENVIRONMENT_HEIGHT));
    vec3 root = stored.rgb * (stored.a * u_environmentRoot);
    return root * root;
}

// Radiance around the reflected direction, filtered by the GGX lobe of a perceptual roughness
// 0 to 1: the first factor of the split sum.
vec3 environmentSpecular(vec3 direction, float roughness) {
    vec2 at = octahedralFromDirection(direction);
    float level = clamp(roughness, 0.0, 1.0) * ENVIRONMENT_LAST_LEVEL;
    float lower = min(floor(level), ENVIRONMENT_LAST_LEVEL - 1.0);
    return mix(environmentLevel(at, lower), environmentLevel(at, lower + 1.0), level - lower);
}
