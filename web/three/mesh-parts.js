// Meshes of three.js in parts, each of which the mask engine treats as a mesh with one material.

import { Matrix4 } from 'three';
import { isAlphaTested } from './alpha-tests.js';
import { sameNumbers } from './mesh-shape.js';
import { isSeeThrough } from './see-through.js';

/** An object with another's members, and its own in their place. */
const variantOf = (of, own) => Object.assign(Object.create(of), own);

/** Part of a geometry: `ranges`, {start, count} of its indices or vertices. */
const geometryPart = (geometry, ranges) => variantOf(geometry, {
  ranges, uuid: `${geometry.uuid} ${ranges.map(({ start, count }) => `${start}+${count}`)}` });

/** The part of a group that drawRange leaves. */
function drawnPart({ start, count }, drawRange) {
  const begin = Math.max(start, drawRange.start);
  return { start: begin, count: Math.min(start + count, drawRange.start + drawRange.count) - begin };
}

/** Instances of a BatchedMesh: {active, visible, geometryIndex} each; null in early releases. */
const instancesOf = (mesh) => mesh._instanceInfo ?? mesh._drawInfo ?? null;

/** Why a mesh can't be in masks, apart from its displacementMap: a clause, or ''. */
export function whyNotInMasks(mesh) {
  const { material } = mesh;
  if (mesh.geometry.attributes.position.isGLBufferAttribute) return 'its vertices are in a buffer of the GPU alone';
  if (material.wireframe) return 'its material is a wireframe';
  if (mesh.isInstancedMesh && mesh.morphTexture) return 'its instances have morph targets of their own';
  if (mesh.isBatchedMesh && !(instancesOf(mesh) && mesh.getGeometryRangeAt)) return "this release's BatchedMesh does not tell its instances";
  return '';
}

export class MeshParts {
  #clippings;
  #known = new WeakMap(); // by mesh: {signature, parts} or, of a BatchedMesh, {geometries, instances, parts}

  constructor(clippings) {
    this.#clippings = clippings;
  }

  /** Parts that stand for a mesh, the same objects until they change; null: the mesh itself. */
  of(mesh) {
    if (mesh.isBatchedMesh && instancesOf(mesh) && mesh.getGeometryRangeAt) return this.#batched(mesh);
    if (Array.isArray(mesh.material) && mesh.geometry) return this.#byTreatment(mesh);
    this.#known.delete(mesh);
    return null;
  }

  /** The result of the last of(mesh). */
  last(mesh) {
    return this.#known.get(mesh)?.parts ?? null;
  }

  /** One part of all groups whose materials masks treat alike. */
  #byTreatment(mesh) {
    const { geometry, material: materials } = mesh;
    const { groups, drawRange } = geometry;
    const treatments = materials.map((material) => (material ? this.#treatmentOf(material, mesh) : ''));
    const signature = [geometry, ...materials, drawRange.start, drawRange.count, ...treatments,
      ...groups.flatMap(({ start, count, materialIndex }) => [start, count, materialIndex])];
    const known = this.#known.get(mesh);
    if (known && sameNumbers(known.signature, signature)) return known.parts;
    const alike = new Map(); // by treatment: {material, ranges}
    for (const group of groups) {
      const material = materials[group.materialIndex], range = drawnPart(group, drawRange);
      if (!material || !(range.count > 0)) continue;
      const treatment = treatments[group.materialIndex];
      if (!alike.has(treatment)) alike.set(treatment, { material, ranges: [] });
      alike.get(treatment).ranges.push(range);
    }
    const parts = [...alike.values()].map(({ material, ranges }, i) =>
      variantOf(mesh, { material, geometry: geometryPart(geometry, ranges), uuid: `${mesh.uuid} ${i}` }));
    this.#known.set(mesh, { signature, parts });
    return parts;
  }

  /** Identifies materials that masks treat alike. */
  #treatmentOf(material, mesh) {
    const { visible, side, wireframe, displacementMap, uuid } = material;
    const clippings = this.#clippings.of(material, mesh);
    return [visible, side, wireframe, (isAlphaTested(material) || isSeeThrough(material) || displacementMap) && uuid,
      clippings.length ? JSON.stringify(clippings) : ''].join();
  }

  /** One part of each visible instance. */
  #batched(mesh) {
    const { geometry } = mesh;
    let known = this.#known.get(mesh);
    if (known?.geometry !== geometry) this.#known.set(mesh, known = { geometry, geometries: [], instances: [], parts: [] });
    known.parts.length = 0;
    for (const [i, { active, visible, geometryIndex }] of instancesOf(mesh).entries()) {
      if (active === false || !visible) continue;
      const { start, count } = mesh.getGeometryRangeAt(geometryIndex);
      const had = known.geometries[geometryIndex]?.ranges[0];
      if (had?.start !== start || had.count !== count) known.geometries[geometryIndex] = geometryPart(geometry, [{ start, count }]);
      const part = known.instances[i] ??= variantOf(mesh, { uuid: `${mesh.uuid} ${i}`, matrixWorld: new Matrix4() });
      part.geometry = known.geometries[geometryIndex];
      mesh.getMatrixAt(i, part.matrixWorld);
      part.matrixWorld.premultiply(mesh.matrixWorld);
      known.parts.push(part);
    }
    return known.parts;
  }
}
