// Precise places of vertices that are far from their mesh's origin, where floats are coarse.

import { ShaderChunk, Vector3 } from 'three';

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

/** Whether all within a radius around a center is far from 0, so that differences from it are exact. */
const isFar = (center, radius) => center.lengthSq() > 256 * radius ** 2;

/**
 * {positions, origin}: x, y, z per vertex relative to an origin. It is [0, 0, 0], and the positions
 * are the same array, unless all are far from there.
 */
export function nearOrigin(positions) {
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
  for (let i = 0; i < positions.length; i += 3) {
    origin.fromArray(positions, i);
    low.min(origin);
    high.max(origin);
  }
  origin.addVectors(low, high).multiplyScalar(0.5);
  if (!isFar(origin, 0.5 * high.distanceTo(low))) return { positions, origin: [0, 0, 0] };
  const numbers = origin.toArray().map(Math.fround);
  return { positions: positions.map((value, i) => value - numbers[i % 3]), origin: numbers };
}

/** Whether one origin suits all vertices of a mesh: neither instances nor bones move them. */
export const canPlaceFar = ({ isInstancedMesh, isBatchedMesh, isSkinnedMesh }) => !(isInstancedMesh || isBatchedMesh || isSkinnedMesh);

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
