// The extent of receivers that masks don't show, such as glass.

import { Box3, Sphere } from 'three';

const around = new Box3(), sphere = new Sphere(), one = new Box3();

/** The corners [low, high] of a box in the world around meshes' bounding spheres. */
export function boxAround(meshes) {
  around.makeEmpty();
  for (const mesh of meshes) {
    const of = mesh.boundingSphere === undefined ? mesh.geometry : mesh; // as three.js culls
    if (of.boundingSphere === null) of.computeBoundingSphere();
    around.union(sphere.copy(of.boundingSphere).applyMatrix4(mesh.matrixWorld).getBoundingBox(one));
  }
  return [around.min.toArray(), around.max.toArray()];
}
