// Caps write only the stencil. Fragments are discarded where the caster itself has none. TINT and
// UNIFORM_TINT: as in sides.frag.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

#ifdef UNIFORM_TINT
uniform vec4 u_tint;
#endif
#ifdef NEAR_DISCARD
varying vec2 v_clipZW;
#endif
#ifdef ALPHA_TEST
uniform sampler2D u_texture;
uniform vec4 u_alphaChannel;  // 1 in the channel that holds alpha
uniform float u_alphaScale;
uniform float u_alphaCutoff; // above any alpha: the caster left nothing in the depth buffer
uniform float u_frontCapAtInfinity;
varying vec3 v_alphaLookup;
varying float v_isBack;
#endif
#ifdef PROBE
varying vec4 v_color;
#endif

void main() {
#ifdef NEAR_DISCARD
    // The caster was clipped here (docs/method.md, C11): a cap moved to infinity would count here.
    if (v_clipZW.x < -v_clipZW.y) discard;
#endif
#ifdef ALPHA_TEST
    // Where the caster is solid its front cap counts at infinity; in its cutouts, in place.
    float alpha = u_alphaScale * v_alphaLookup.z *
                  dot(texture2D(u_texture, v_alphaLookup.xy), u_alphaChannel);
    bool solid = alpha >= u_alphaCutoff;
    if (v_isBack < 0.5 && solid != (u_frontCapAtInfinity > 0.5)) discard;
#endif
#ifdef PROBE
    gl_FragColor = v_color;
#elif defined(TINT)
    gl_FragColor = TINT;
#else
    gl_FragColor = vec4(1.0);
#endif
}
