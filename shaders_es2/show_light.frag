// Maps accumulated light to the display's colours.
precision highp float;

uniform highp sampler2D u_light;
uniform vec2 u_size; // 1 / pixels

#include "tone_mapping.glsl"

void main() {
    gl_FragColor = vec4(displayed(texture2D(u_light, gl_FragCoord.xy * u_size).rgb), 1.0);
}
