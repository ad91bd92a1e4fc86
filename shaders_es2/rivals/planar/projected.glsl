// Projects a point from the light onto a plane, as the eye sees it there.
#include "extrusion.glsl"

uniform mat4 u_clipFromObject;
uniform vec4 u_light; // in object space
uniform vec4 u_plane; // in object space, positive on the light's side

varying float v_height; // above the plane; linear over a triangle, since the projection is
                        // projective

// A point behind the eye, or at or above the light's height, either has no w > 0 and is clipped, or
// is rejected by its height. Depth is not needed.
void emitProjected(vec3 p) {
    v_height = u_plane.x * p.x + u_plane.y * p.y + u_plane.z * p.z + u_plane.w;
    vec4 clip = clipPosition(u_clipFromObject, pushedTo(u_plane, p, u_light));
    gl_Position = vec4(clip.xy, 0.0, keptOffEye(clip));
}
