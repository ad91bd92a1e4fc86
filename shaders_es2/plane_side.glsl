// The side of a triangle's plane that a light is on (docs/method.md, C1). Written in the common
// part of GLSL ES 1.00 and C++ with GLM; one evaluation order everywhere, as in multiplicity.glsl.

// Returns 1 if the light sees the triangle counter-clockwise, -1 if clockwise, 0 if the light lies
// in the triangle's plane or no farther from it than `reach`. `reach` is 0 unless the light touches
// a caster (C47).
float planeSide(vec4 plane, vec4 light, float reach) {
    float side = plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w;
    return reach < side || side < -reach ? sign(side) : 0.0;
}

// The part of planeSide() that counts (docs/method.md, C8). counted: (-1, 1), every triangle; (0,
// 1), only light-facing ones; (-1, 0), only those that face away.
float countedSide(vec4 plane, vec4 light, float reach, vec2 counted) {
    return clamp(planeSide(plane, light, reach), counted.x, counted.y);
}
