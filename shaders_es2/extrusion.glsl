// Extruded positions, one evaluation order for every program: sides and caps must meet bit for bit.

// toInf of the method (thesis, Equation 6.1): p pushed away from the light to infinity.
vec4 toInfinity(vec3 p, vec4 light) {
    return vec4(p.x * light.w - light.x, p.y * light.w - light.y, p.z * light.w - light.z, 0.0);
}

// matrix * p, its sum spelled out.
vec4 clipPosition(mat4 matrix, vec4 p) {
    return matrix[0] * p.x + matrix[1] * p.y + matrix[2] * p.z + matrix[3] * p.w;
}

// 1 / 65536. Moves such a vertex by the same share of its distance.
const float leastDepthShare = 0.0000152587890625;

// The place of a vertex for gl_Position, kept off the plane through the eye. Next to it (the light,
// the vertex and the eye's picture plane in one plane, say) a vertex projects so far away that
// fixed-point rasterisers overflow and lose the triangle. A vertex at infinity (z = w) stays there.
vec4 rasterizable(vec4 clip) {
    float least = leastDepthShare * max(abs(clip.x), abs(clip.y));
    float w = clip.w < 0.0 ? -least : least;
    return abs(clip.w) < least ? vec4(clip.xy, w + (clip.z - clip.w), w) : clip;
}
