uniform vec2 u_neutralAmbient;
vec3 environmentDiffuse(vec3 normal) { return vec3(1.0 + 0.35 * normal.y); }
vec3 environmentSpecular(vec3 direction, float roughness) {
    float width = 0.08 + 0.92 * roughness;
    float up = smoothstep(-width, width, direction.y);
    return vec3(mix(0.55, 1.6, up));
}
