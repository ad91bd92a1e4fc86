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

/** A range of indices or vertices: its first one, and whole triangles' number of corners. */
function drawnOf({ index, attributes: { position } }, { start, count }) {
  const all = index ? index.count : position.count;
  const begin = Math.min(Math.max(start, 0), all);
  const whole = 3 * Math.floor((Math.min(start + count, all) - begin) / 3);
  return { begin, corners: Math.max(whole, 0) };
}

/** The number of triangles of the drawn part of a mesh. */
export const trianglesOf = ({ geometry }) =>
  (geometry.ranges ?? [geometry.drawRange]).reduce((sum, range) => sum + drawnOf(geometry, range).corners / 3, 0);

/** Numbers of vertices, three per triangle, in a range of indices or vertices. */
function indicesOf(geometry, range) {
  const { begin, corners } = drawnOf(geometry, range), { index } = geometry;
  const numbers = new Uint32Array(corners);
  if (index?.isBufferAttribute) numbers.set(index.array.subarray(begin, begin + corners));
  else for (let i = 0; i < numbers.length; ++i) numbers[i] = index ? index.getX(begin + i) : begin + i;
  return numbers;
}

/**
 * {positions, indices, first} of the drawn part of a mesh, in its own space. `first`: number of the
 * first vertex among the mesh's; others than 0 for parts (see MeshParts). `moved(positions)` returns those of
 * all vertices as they are drawn.
 */
export function shapeOf(mesh, moved) {
  const { geometry } = mesh;
  const { ranges } = geometry;
  if (!ranges) return { positions: moved(positionsOf(mesh)), indices: indicesOf(geometry, geometry.drawRange), first: 0 };
  const numbers = ranges.flatMap((range) => [...indicesOf(geometry, range)]);
  let first = Infinity, last = -1;
  for (const n of numbers) {
    first = Math.min(first, n);
    last = Math.max(last, n);
  }
  return { positions: moved(positionsOf(mesh)).subarray(3 * first, 3 * last + 3), indices: Uint32Array.from(numbers, (n) => n - first), first };
}
