// What a triangle's plane says of a light (docs/method.md, C1). Written in the common part of
// GLSL ES 1.00 and C++ with GLM; one evaluation order everywhere, as in multiplicity.glsl.

// The side of the plane that the light is on: 1 if the light sees the triangle counter-clockwise,
// -1 if clockwise, 0 if the light lies in its plane.
float planeSide(vec4 plane, vec4 light) {
    return sign(plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w);
}

// What counts of it (docs/method.md, C8). counted: (-1, 1), every triangle; (0, 1), light-facing
// ones alone; (-1, 0), those that face away alone.
float countedSide(vec4 plane, vec4 light, vec2 counted) {
    return clamp(planeSide(plane, light), counted.x, counted.y);
}
