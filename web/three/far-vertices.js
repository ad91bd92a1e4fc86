// Precise places of vertices that are far from their mesh's origin, where floats are coarse.

import { ShaderChunk, Vector3 } from 'three';
import { canPlaceFar, isFar } from './near-origin.js';

const included = '#include <project_vertex>';
const product = 'mvPosition = modelViewMatrix * mvPosition;';

/**
 * The matrix's fourth row, which is 0, 0, 0, 1 in three.js, holds an origin that its translation is
 * of. Nearby, differences from it are exact.
 */
const preciseProduct = /* glsl */`
	mvPosition.xyz -= vec3( modelViewMatrix[ 0 ].w, modelViewMatrix[ 1 ].w, modelViewMatrix[ 2 ].w );
	mvPosition = vec4( ( modelViewMatrix * mvPosition ).xyz, 1.0 );
`;

/** A vertex shader that takes such matrices; the same one if it doesn't place vertices as three.js does. */
export const takesOrigins = (vertexShader) => vertexShader.replace(included, () => ShaderChunk.project_vertex.replace(product, preciseProduct));

const origin = new Vector3(), place = new Vector3();

/** Gives a mesh's matrix an origin, in doubles, if all of its vertices are far from their own. */
export function placeFarVertices(mesh) {
  const { geometry: { boundingSphere: sphere }, modelViewMatrix } = mesh;
  if (!sphere || !canPlaceFar(mesh) || !isFar(sphere.center, sphere.radius)) return;
  const { x, y, z } = sphere.center, { elements } = modelViewMatrix;
  origin.set(Math.fround(x), Math.fround(y), Math.fround(z));
  place.copy(origin).applyMatrix4(modelViewMatrix);
  [elements[3], elements[7], elements[11]] = [origin.x, origin.y, origin.z];
  [elements[12], elements[13], elements[14]] = [place.x, place.y, place.z];
}
