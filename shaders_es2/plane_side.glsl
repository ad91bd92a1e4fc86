// What a triangle's plane says of a light (docs/method.md, C1). Written in the common part of
// GLSL ES 1.00 and C++ with GLM; one evaluation order everywhere, as in multiplicity.glsl.

// The side of the plane that the light is on: 1 if the light sees the triangle counter-clockwise,
// -1 if clockwise, 0 if the light lies in its plane, or no farther off than `reach`: that is 0 but for
// a light that touches a caster (C47).
float planeSide(vec4 plane, vec4 light, float reach) {
    float side = plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w;
    return reach < side || side < -reach ? sign(side) : 0.0;
}

// What counts of it (docs/method.md, C8). counted: (-1, 1), every triangle; (0, 1), light-facing
// ones alone; (-1, 0), those that face away alone.
float countedSide(vec4 plane, vec4 light, float reach, vec2 counted) {
    return clamp(planeSide(plane, light, reach), counted.x, counted.y);
}
