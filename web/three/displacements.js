// Vertices that a displacementMap moves, moved by the GPU as three.js's vertex shader does, and read back.

import { bindOn, drawOver, programOver } from './drawing-over.js';
import { isPosed } from './mesh-shape.js';
import { texcoordsOfTexture } from './texture-products.js';
import { uploadedIn } from './uploaded-texture.js';

/** Vertices in a row of the picture. */
const columns = 1024;

const fragmentShader = `#version 300 es
precision highp float;
uniform highp sampler2D vertices; // two texels for each: position and u, normal and v
uniform highp sampler2D displacementMap;
uniform mat3 transform;
uniform vec2 amount; // scale, bias
uniform bool loaded;
out vec4 moved;
void main() {
	ivec2 at = ivec2( gl_FragCoord.xy ) * ivec2( 2, 1 );
	vec4 a = texelFetch( vertices, at, 0 ), b = texelFetch( vertices, at + ivec2( 1, 0 ), 0 );
	float height = loaded ? textureLod( displacementMap, ( transform * vec3( a.w, b.w, 1.0 ) ).xy, 0.0 ).x : 0.0;
	moved = vec4( a.xyz + normalize( b.xyz ) * ( height * amount.x + amount.y ), 1.0 );
}`;

export class Displacements {
  #renderer;
  #masks;
  #touched;
  #program = null;
  #lacked = new WeakSet(); // materials

  /** `touched()` is called when the context's state may have changed. */
  constructor(renderer, masks, touched) {
    this.#renderer = renderer;
    this.#masks = masks;
    this.#touched = touched;
  }

  /** Whether some meshes of a displaced material can't be moved here. */
  lacks(material) {
    return this.#lacked.has(material);
  }

  /** Why a displaced mesh can't be moved here: a clause, or ''. */
  obstacleOf(mesh) {
    const why = this.#whyNot(mesh);
    if (why) this.#lacked.add(mesh.material);
    return why;
  }

  #whyNot(mesh) {
    const { geometry: { attributes }, material: { displacementMap } } = mesh;
    if (isPosed(mesh)) return "its material's displacementMap moves vertices that bones or morph targets move, too";
    if (!attributes.normal || !attributes[texcoordsOfTexture(displacementMap)]) return 'its displacementMap has no normals or texture coordinates';
    return this.#renderer.getContext().getExtension('EXT_color_buffer_float') ? '' : 'this device has no pictures of floats to displace its vertices in';
  }

  /** Text that changes with what displaces a mesh, apart from its positions. */
  versionOf({ geometry: { attributes }, material: { displacementMap: map, displacementScale, displacementBias } }) {
    const uploaded = uploadedIn(this.#renderer, map), uv = attributes[texcoordsOfTexture(map)], { normal } = attributes;
    if (map.matrixAutoUpdate) map.updateMatrix();
    return [map.uuid, uploaded && this.#renderer.properties.get(map.source).__version, map.wrapS, map.wrapT, map.magFilter, displacementScale, displacementBias,
      ...map.matrix.elements, ...[uv, normal].map((of) => of.data?.version ?? of.version)].join();
  }

  /** Three numbers a vertex, in place of a mesh's positions. */
  moved(mesh, positions) {
    const { geometry: { attributes: { normal, ...attributes } }, material: { displacementMap, displacementScale, displacementBias } } = mesh;
    const uv = attributes[texcoordsOfTexture(displacementMap)], count = positions.length / 3, rows = Math.ceil(count / columns);
    const gl = this.#renderer.getContext(), texels = new Float32Array(8 * columns * rows), picture = new Float32Array(4 * columns * rows);
    for (let i = 0; i < count; ++i) {
      texels.set(positions.subarray(3 * i, 3 * i + 3), 8 * i);
      texels.set([uv.getX(i), normal.getX(i), normal.getY(i), normal.getZ(i), uv.getY(i)], 8 * i + 3);
    }
    const webGlTexture = uploadedIn(this.#renderer, displacementMap);
    this.#masks.keptWhile(() => {
      const program = this.#program ??= programOver(gl, fragmentShader);
      const [vertices, target] = [[2 * columns, texels], [columns, null]].map(([width, numbers]) => {
        const texture = gl.createTexture();
        bindOn(gl, 0, texture);
        gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, rows, 0, gl.RGBA, gl.FLOAT, numbers);
        for (const filter of ['MIN', 'MAG']) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${filter}_FILTER`], gl.NEAREST);
        return texture;
      });
      drawOver(gl, program, target, [columns, rows], (at) => {
        bindOn(gl, 0, vertices);
        bindOn(gl, 1, webGlTexture);
        gl.uniform1i(at('displacementMap'), 1);
        gl.uniform1i(at('loaded'), webGlTexture ? 1 : 0);
        gl.uniformMatrix3fv(at('transform'), false, displacementMap.matrix.elements);
        gl.uniform2f(at('amount'), displacementScale, displacementBias);
      }, () => {
        gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
        gl.readPixels(0, 0, columns, rows, gl.RGBA, gl.FLOAT, picture);
      });
      for (const texture of [vertices, target]) gl.deleteTexture(texture);
    });
    this.#touched();
    return new Float32Array(3 * count).map((_, i) => picture[4 * Math.floor(i / 3) + i % 3]);
  }

  /** Called when the context is lost. */
  forget() {
    this.#program = null;
  }

  dispose() {
    if (this.#program) this.#renderer.getContext().deleteProgram(this.#program);
    this.forget();
  }
}
