// Positions that are far from their mesh's origin, relative to one that is near them.

import { Vector3 } from 'three';

const low = new Vector3(), high = new Vector3(), origin = new Vector3();

/** Whether all within a radius around a center is far from 0, so that differences from it are exact. */
export const isFar = (center, radius) => center.lengthSq() > 256 * radius ** 2;

/**
 * {positions, origin}: x, y, z per vertex relative to an origin. It is [0, 0, 0], and the positions
 * are the same array, unless all are far from there.
 */
export function nearOrigin(positions) {
  low.setScalar(Infinity);
  high.setScalar(-Infinity);
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
