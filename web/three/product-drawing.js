// Products of textures, drawn by a WebGLRenderer's context.

import { ClampToEdgeWrapping, MirroredRepeatWrapping, NearestFilter } from 'three';
import { bindOn, drawOver, programOver } from './drawing-over.js';

const fragmentShader = `#version 300 es
precision highp float;
uniform sampler2D alphaMap, map, transmissionMap;
uniform mat3 placing[ 3 ];
uniform bvec3 has;
uniform vec2 size;
uniform vec3 seeThrough; // opacity, transmission, and 1 for a tint
out vec4 product;
void main() {
	vec3 at = vec3( gl_FragCoord.xy / size, 1.0 );
	float green = has.x ? textureLod( alphaMap, ( placing[ 0 ] * at ).xy, 0.0 ).g : 1.0;
	vec4 base = has.y ? textureLod( map, ( placing[ 1 ] * at ).xy, 0.0 ) : vec4( 1.0 );
	float red = has.z ? textureLod( transmissionMap, ( placing[ 2 ] * at ).xy, 0.0 ).r : 1.0;
	float alpha = green * base.a;
	// Opaque materials ignore alpha.
	float through = 1.0 - ( seeThrough.x < 0.0 ? 1.0 : seeThrough.x * alpha ) * ( 1.0 - seeThrough.y * red );
	product = seeThrough.z > 0.0 ? vec4( base.rgb * through, 1.0 ) : vec4( alpha );
}`;

/** The drawing of TextureProducts. */
export class ProductDrawing {
  #renderer;
  #masks;
  #touched;
  #program = null;

  /** `touched()` is called when the context's state may have changed. */
  constructor(renderer, masks, touched) {
    this.#renderer = renderer;
    this.#masks = masks;
    this.#touched = touched;
  }

  versionOf({ source }) {
    return this.#renderer.properties.get(source).__version; // of the last upload
  }

  begun() {
    return this.#renderer.getContext().createTexture();
  }

  draw(webGlTexture, plan) {
    this.#renderer.properties.get(plan.texture.source).__version = plan.version;
    this.#masks.keptWhile(() => this.#draw(this.#renderer.getContext(), webGlTexture, plan));
    this.#touched();
  }

  freed(webGlTexture) {
    this.#renderer.getContext().deleteTexture(webGlTexture);
  }

  forget() {
    this.#program = null;
  }

  dispose() {
    if (this.#program) this.#renderer.getContext().deleteProgram(this.#program);
    this.forget();
  }

  #draw(gl, webGlTexture, { texture: { image: { width, height }, wrapS, wrapT, magFilter }, textures, matrices, seeThrough, hasMipmaps }) {
    const program = this.#program ??= programOver(gl, fragmentShader);
    const wrapOf = (mode) => (mode === ClampToEdgeWrapping ? gl.CLAMP_TO_EDGE : mode === MirroredRepeatWrapping ? gl.MIRRORED_REPEAT : gl.REPEAT);
    const floats = gl.getExtension('EXT_color_buffer_float'); // 11 bits, else 8
    const format = !floats ? ['RGBA8', 'RGBA', 'UNSIGNED_BYTE'] : seeThrough[2] ? ['RGBA16F', 'RGBA', 'HALF_FLOAT'] : ['RG16F', 'RG', 'HALF_FLOAT'];
    const [inner, outer, type] = format.map((name) => gl[name]);
    bindOn(gl, 0, webGlTexture);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
    gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, outer, type, null);
    const filter = magFilter === NearestFilter ? gl.NEAREST : gl.LINEAR;
    for (const [name, value] of [['MAG_FILTER', filter], ['MIN_FILTER', hasMipmaps ? gl.LINEAR_MIPMAP_LINEAR : filter], ['WRAP_S', wrapOf(wrapS)], ['WRAP_T', wrapOf(wrapT)]])
      gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], value);
    drawOver(gl, program, webGlTexture, [width, height], (at) => {
      gl.uniform2f(at('size'), width, height);
      gl.uniform3f(at('seeThrough'), ...seeThrough);
      gl.uniform3i(at('has'), ...textures.map(Boolean));
      gl.uniformMatrix3fv(at('placing'), false, matrices.flatMap(({ elements }) => elements));
      for (const [unit, name] of ['alphaMap', 'map', 'transmissionMap'].entries()) {
        const texture = textures[unit];
        gl.uniform1i(at(name), unit);
        bindOn(gl, unit, texture && this.#renderer.properties.get(texture).__webglTexture);
      }
    });
    bindOn(gl, 0, webGlTexture);
    if (hasMipmaps) gl.generateMipmap(gl.TEXTURE_2D);
  }
}
