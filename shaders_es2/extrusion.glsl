// Extruded positions, one evaluation order for every program: sides and caps must meet bit for bit.

// toInf of the method (thesis, Equation 6.1): p pushed away from the light to infinity.
vec4 toInfinity(vec3 p, vec4 light) {
    return vec4(p.x * light.w - light.x, p.y * light.w - light.y, p.z * light.w - light.z, 0.0);
}

// matrix * p, its sum spelled out.
vec4 clipPosition(mat4 matrix, vec4 p) {
    return matrix[0] * p.x + matrix[1] * p.y + matrix[2] * p.z + matrix[3] * p.w;
}
