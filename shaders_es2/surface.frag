// Base colour times ambient plus Lambert light, in the display's own (sRGB) values. The lit pass
// adds one light at a time. Variants: ALPHA_TEST, materials with holes; BLENDED, see-through ones.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform sampler2D u_texture;
uniform vec4 u_baseColor;   // sRGB
uniform float u_ambient;
uniform float u_diffuse;
uniform float u_mirrored;   // 1, or -1 where the node's transform turns triangles over
uniform float u_mask;       // 1: draw u_maskValue, for the lit mask
uniform float u_maskValue;
#ifdef ALPHA_TEST
uniform float u_alphaCutoff;
#endif

varying vec3 v_normal;
varying vec3 v_towardsLight;
varying vec2 v_texcoord;
varying vec4 v_color;

void main() {
    vec4 base = u_baseColor * v_color * texture2D(u_texture, v_texcoord);
#ifdef ALPHA_TEST
    if (base.a < u_alphaCutoff) discard;
#endif
    // Scaled before it is squared, so that far-off lights don't overflow.
    vec3 light = v_towardsLight / max(max(abs(v_towardsLight.x), abs(v_towardsLight.y)),
                                      max(abs(v_towardsLight.z), 1e-30));
    vec3 normal = v_normal * (gl_FrontFacing ? u_mirrored : -u_mirrored);
    float lambert = max(dot(normalize(normal), normalize(light)), 0.0);
    vec3 shaded = base.rgb * (u_ambient + u_diffuse * lambert);
#ifdef BLENDED
    float alpha = base.a;
#else
    float alpha = 1.0;
#endif
    gl_FragColor = vec4(mix(shaded, vec3(u_maskValue), u_mask), alpha);
}
