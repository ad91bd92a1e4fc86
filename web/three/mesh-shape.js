// The triangles of three.js's meshes, as the mask engine takes them.

import { Vector3 } from 'three';

const vertex = new Vector3();

export const sameNumbers = (a, b) => a.length === b.length && a.every((number, i) => number === b[i]);

/** Whether its shape is other than its geometry's: bent by bones or morphed. */
export const isPosed = (mesh) => Boolean(mesh.isSkinnedMesh || mesh.geometry.morphAttributes.position?.length);

/** Changes when the triangles do, or the texture coordinates of that name, if there is one. */
export function versionOf({ geometry }, texcoords) {
  const { index, attributes, drawRange } = geometry;
  const { position } = attributes;
  const dataVersion = (attribute) => attribute?.data?.version ?? attribute?.version ?? 0;
  return [position.count, dataVersion(position), index?.count, dataVersion(index), drawRange.start, drawRange.count,
    texcoords, dataVersion(attributes[texcoords])].join();
}

/** Likewise, of what bends it; numbers, to be compared one by one. */
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

/** u, v a vertex, of three.js' name for them; none where the geometry has none. */
export function texcoordsOf({ geometry }, name) {
  const attribute = geometry.attributes[name];
  const texcoords = new Float32Array(attribute ? 2 * geometry.attributes.position.count : 0);
  for (let i = 0; 2 * i < texcoords.length; ++i) texcoords.set([attribute.getX(i), attribute.getY(i)], 2 * i);
  return texcoords;
}

/** {positions, indices} of what is drawn of a mesh, in its own space. */
export function shapeOf(mesh) {
  const { geometry } = mesh;
  const { index, attributes: { position }, drawRange } = geometry;
  const count = index ? index.count : position.count;
  const begin = Math.min(Math.max(drawRange.start, 0), count);
  const whole = 3 * Math.floor((Math.min(drawRange.start + drawRange.count, count) - begin) / 3);
  const indices = new Uint32Array(Math.max(whole, 0));
  for (let i = 0; i < indices.length; ++i) indices[i] = index ? index.getX(begin + i) : begin + i;
  return { positions: positionsOf(mesh), indices };
}
