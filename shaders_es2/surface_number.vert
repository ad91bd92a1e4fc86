// Surfaces coloured by their triangles' numbers, at the positions of surface.vert. Variants:
// ALPHA_TEST, materials with cutouts; SLICED, discards whatever is deeper than u_farthest.
#include "extrusion.glsl"

attribute vec3 a_position;
attribute float a_number; // of the triangle, among those of its mesh
#ifdef ALPHA_TEST
attribute vec2 a_texcoord;
attribute float a_alpha; // the vertex colour's
#endif

uniform mat4 u_clipFromObject;
uniform float u_firstNumber; // of the mesh: numbers in the picture stay below 2^24
#ifdef ALPHA_TEST
uniform mat3 u_texcoordTransform;
varying vec2 v_texcoord;
varying float v_alpha;
#endif
#ifdef SLICED
varying float v_depth;
#endif
varying vec3 v_number; // its bytes, the lowest first, as shares of 255

invariant gl_Position;

void main() {
    float number = u_firstNumber + a_number;
    float high = floor(number / 65536.0);
    float rest = number - 65536.0 * high;
    float middle = floor(rest / 256.0);
    v_number = vec3(rest - 256.0 * middle, middle, high) / 255.0;
#ifdef ALPHA_TEST
    v_texcoord = (u_texcoordTransform * vec3(a_texcoord, 1.0)).xy;
    v_alpha = a_alpha;
#endif
    gl_Position = rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, vec4(a_position, 1.0)));
#ifdef SLICED
    v_depth = gl_Position.w;
#endif
}
