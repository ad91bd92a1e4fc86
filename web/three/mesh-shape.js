// Triangles of three.js's meshes in the mask engine's form.

import { Vector3 } from 'three';

const vertex = new Vector3();

export function sameNumbers(a, b) {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}

/** Whether a mesh has another shape than its geometry: skinned or morphed. */
export const isPosed = (mesh) => Boolean(mesh.isSkinnedMesh || mesh.geometry.morphAttributes.position?.length);

const dataVersion = (attribute) => attribute?.data?.version ?? attribute?.version ?? 0;

/**
 * Versions that change with the triangles, and with the texture coordinates of that name, if there
 * is one. They are written into `versions`, so that following thousands of meshes makes no garbage.
 */
export function versionsOf({ geometry }, texcoords, versions = []) {
  const { index, attributes, drawRange } = geometry;
  const { position } = attributes;
  versions[0] = position.count;
  versions[1] = dataVersion(position);
  versions[2] = index?.count;
  versions[3] = dataVersion(index);
  versions[4] = drawRange.start;
  versions[5] = drawRange.count;
  versions[6] = texcoords;
  versions[7] = texcoords && dataVersion(attributes[texcoords]);
  return versions;
}

/** The pose of a bent mesh: numbers, to be compared one by one. */
export function poseOf(mesh) {
  const numbers = [...(mesh.morphTargetInfluences ?? [])];
  if (!mesh.isSkinnedMesh) return numbers;
  for (const bone of mesh.skeleton.bones) numbers.push(...bone.matrixWorld.elements);
  numbers.push(...mesh.bindMatrix.elements, ...mesh.bindMatrixInverse.elements, ...mesh.matrixWorld.elements);
  return numbers;
}

function positionsOf(mesh) {
  const { position } = mesh.geometry.attributes;
  const posed = isPosed(mesh);
  const plain = position.isBufferAttribute && !position.isInterleavedBufferAttribute &&
    position.array instanceof Float32Array && position.itemSize === 3;
  if (plain && !posed) return position.array.subarray(0, 3 * position.count);
  const positions = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; ++i) {
    if (posed) mesh.getVertexPosition(i, vertex);
    else vertex.fromBufferAttribute(position, i);
    vertex.toArray(positions, 3 * i);
  }
  return positions;
}

/** u, v per vertex, for three.js's name of the coordinates; none if the geometry has none. */
export function texcoordsOf({ geometry }, name) {
  const attribute = geometry.attributes[name];
  const texcoords = new Float32Array(attribute ? 2 * geometry.attributes.position.count : 0);
  for (let i = 0; 2 * i < texcoords.length; ++i) texcoords.set([attribute.getX(i), attribute.getY(i)], 2 * i);
  return texcoords;
}

/** The drawn part of a mesh: its first corner, and whole triangles' number of corners. */
function drawnOf({ geometry: { index, attributes: { position }, drawRange } }) {
  const count = index ? index.count : position.count;
  const begin = Math.min(Math.max(drawRange.start, 0), count);
  const whole = 3 * Math.floor((Math.min(drawRange.start + drawRange.count, count) - begin) / 3);
  return { begin, corners: Math.max(whole, 0) };
}

export const trianglesOf = (mesh) => drawnOf(mesh).corners / 3;

/** {positions, indices} of the drawn part of a mesh, in its own space. */
export function shapeOf(mesh) {
  const { index } = mesh.geometry;
  const { begin, corners } = drawnOf(mesh);
  const indices = new Uint32Array(corners);
  if (index?.isBufferAttribute) indices.set(index.array.subarray(begin, begin + corners));
  else for (let i = 0; i < indices.length; ++i) indices[i] = index ? index.getX(begin + i) : begin + i;
  return { positions: positionsOf(mesh), indices };
}
