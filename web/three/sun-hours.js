// Hours of sun on a host's meshes, counted by rays in a worker of its own. Loaded when they are asked for.

import { BackSide, BufferAttribute, BufferGeometry, Vector3 } from 'three';
import { texcoordsNameOf } from './alpha-tests.js';
import { isPosed, texcoordsOf } from './mesh-shape.js';

const fail = (sentence) => {
  throw new Error(`sunHours(): ${sentence}.`);
};

const isNumber = (value, low, high = Infinity) => typeof value === 'number' && value >= low && value <= high;

/** Sun positions as the worker takes them. */
function daysOf({ place, date, times, step = 10, hours = [0, 24], utcOffset = '', minAltitude = 0, north = 0 }) {
  if (!isNumber(place?.[0], -90, 90) || !isNumber(place[1], -180, 180)) fail('place must be [latitude, longitude] in degrees');
  if (!isNumber(minAltitude, -90, 90)) fail('minAltitude must be degrees');
  if (!isNumber(north, -Infinity)) fail('north must be degrees');
  if (!isNumber(step, 1, 1440)) fail('step must be minutes, 1 to 1440');
  const sun = { place: [...place], step, minAltitude, north };
  if (times) {
    const seconds = Float64Array.from(times, (time) => time / 1000);
    if (date !== undefined || !seconds.every(Number.isFinite)) fail('times must be dates, and take the place of date');
    return { ...sun, times: seconds };
  }
  const [from, to = from] = [date].flat();
  if (typeof from !== 'string' || typeof to !== 'string') fail("date must be '2026-03-21', or two of them, unless times are given");
  if (!Number.isInteger(step) || !isNumber(hours[0], 0, 24) || !isNumber(hours[1], hours[0], 24) || hours[0] === hours[1] ||
    (60 * (hours[1] - hours[0])) % step !== 0)
    fail('step must be whole minutes that divide the clock hours, two from 0 to 24');
  return { ...sun, from, to, hours: [...hours], utcOffset };
}

/** A mesh as the worker takes it, of a part's shape; its arrays are copies. `places`: matrices' elements, or null. */
function meshOf({ positions, indices }, part, places, casts, measured) {
  const inward = part.material?.side === BackSide; // a face's front is where its corners run counter-clockwise
  if (inward) for (let i = 0; i < indices.length; i += 3) [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]];
  const sound = places.filter((elements) => elements?.every(Number.isFinite));
  return { positions: positions.slice(), indices, places: Float64Array.from(sound.flat()), casts, measured };
}

/** Texture coordinates of a part's vertices where its alpha is sampled. */
function sampledAt(part, { texcoordTransform: m }, first, count) {
  const uv = texcoordsOf(part, texcoordsNameOf(part.material)).subarray(2 * first, 2 * (first + count));
  const sampled = new Float32Array(2 * count); // 0 where the geometry has none
  for (let i = 0; i < uv.length; i += 2) sampled.set([m[0] * uv[i] + m[3] * uv[i + 1] + m[6], m[1] * uv[i] + m[4] * uv[i + 1] + m[7]], i);
  return sampled;
}

/** Casters as the worker takes them; textures' texels go into `texels`, once each. */
function casterMeshes(casters, measures, texels) {
  const numbers = new Map(); // index in `texels`, by number
  return casters.casting.map(({ part, whole, places, alpha, clippings }) => {
    const shape = casters.shapeOf(part);
    const mesh = { ...meshOf(shape, part, places, true, measures(whole)), clippings };
    if (!alpha) return mesh;
    const { opacity, cutoff, texels: number } = alpha;
    if (number !== null && !numbers.has(number)) numbers.set(number, texels.push(casters.texelsOf(number)) - 1);
    return { ...mesh, alpha: { opacity, cutoff, texels: numbers.get(number) ?? -1, texcoords: sampledAt(part, alpha, shape.first, shape.positions.length / 3) } };
  });
}

/** The mesh whose vertices are measured. */
function requireMesh(mesh) {
  const { name, geometry } = mesh;
  const which = `mesh '${name}'`;
  if (!mesh.isMesh) fail(`object '${name}' is no mesh, so that only a grid can measure it`);
  if (mesh.isInstancedMesh || mesh.isBatchedMesh) fail(`${which} stands at several places, so that only a grid can measure it`);
  if (isPosed(mesh) || mesh.material.displacementMap) fail(`${which} is skinned, morphed or displaced, so that only a grid can measure it`);
  if (!mesh.matrixWorld.determinant()) fail(`${which} is scaled to nothing`); // or NaN
  if (!geometry.attributes.normal) fail(`${which} has no normals, by which vertices face the sky`);
}

/** A vector for each vertex, as floats. */
function vectorsOf(attribute, count) {
  const vectors = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) vectors.set([attribute.getX(i), attribute.getY(i), attribute.getZ(i)], 3 * i);
  return vectors;
}

/** All meshes, with those to measure last. */
function taskOf(object, casters, { grid, offset = 0 }, days) {
  const texels = [];
  if (grid === undefined) {
    requireMesh(object);
    const { geometry, matrixWorld, material } = object;
    const meshes = casterMeshes(casters, () => false, texels);
    // Its vertices come last, without triangles, which cast only as its casters do.
    const { position, normal } = geometry.attributes;
    const corners = { positions: vectorsOf(position, position.count), indices: new Uint32Array(), casts: false, measured: false };
    const normals = vectorsOf(normal, position.count);
    if (material.side === BackSide) for (let i = 0; i < normals.length; ++i) normals[i] *= -1;
    return { days, texels, meshes: [...meshes, { ...corners, places: Float64Array.from(matrixWorld.elements) }], normals };
  }
  if (!isNumber(grid, Number.MIN_VALUE) || !isNumber(offset, 0)) fail('grid must be above 0, and offset 0 or more, in scene units');
  const measured = new Set();
  object.traverseVisible((one) => one.isMesh && measured.add(one));
  const known = new Set(casters.casting.map(({ whole }) => whole));
  const others = [...measured].filter((mesh) => !known.has(mesh)).map((mesh) => meshOf(casters.shapeOf(mesh), mesh, placesOf(mesh), false, true));
  if (measured.size === 0) fail('there is no visible mesh to measure');
  return { days, texels, grid, offset, meshes: [...casterMeshes(casters, (whole) => measured.has(whole), texels), ...others] };
}

/** Places of a mesh that casts nothing. */
function placesOf(mesh) {
  if (mesh.isBatchedMesh) fail(`mesh '${mesh.name}' is batched and casts nothing, so that it can't be measured`);
  if (!mesh.isInstancedMesh) return [mesh.matrixWorld.elements];
  return Array.from({ length: mesh.count }, (_, i) => {
    const place = mesh.matrixWorld.clone();
    mesh.getMatrixAt(i, place);
    return place.premultiply(mesh.matrixWorld).elements;
  });
}

/** The worker's result; cancels it on `signal`. */
function workOn(task, { signal, onProgress }) {
  const worker = new Worker(new URL('./sun-hours-worker.js', import.meta.url), { type: 'module' });
  let leave;
  return new Promise((resolve, reject) => {
    leave = () => reject(signal.reason);
    signal?.addEventListener('abort', leave);
    worker.onmessage = ({ data: { share, result, problem } }) => {
      if (result) resolve(result);
      else if (problem) reject(new Error(`sunHours(): ${problem.replace(/^--/, '').replace(/\.?$/, '.')}`));
      else onProgress?.(share);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(`The browser stopped the worker that counts hours of sun${event.message ? ` (${event.message})` : ''}.`));
    };
    const meshes = task.meshes.filter(({ places }) => places.length > 0);
    worker.postMessage({ ...task, meshes }, meshes.flatMap(({ positions, indices }) => [positions.buffer, indices.buffer]));
  }).finally(() => {
    signal?.removeEventListener('abort', leave);
    worker.terminate();
  });
}

/** A geometry of the cells, around `origin`, with their hours. */
function geometryOf({ normals, faceCounts, cornerCounts, corners }, hours, origin) {
  const position = [], normal = [], ofCorner = [], index = [];
  let face = 0, corner = 0;
  for (let cell = 0; cell < faceCounts.length; ++cell)
    for (let f = 0; f < faceCounts[cell]; ++f, ++face) {
      const first = corner;
      for (let i = 0; i < cornerCounts[face]; ++i, ++corner) {
        for (let c = 0; c < 3; ++c) position.push(corners[3 * corner + c] - origin.getComponent(c));
        normal.push(...normals.subarray(3 * cell, 3 * cell + 3));
        ofCorner.push(hours[cell]);
        if (i > 1) index.push(first, corner - 1, corner);
      }
    }
  const geometry = new BufferGeometry().setIndex(index);
  for (const [name, numbers, size] of [['position', position, 3], ['normal', normal, 3], ['hours', ofCorner, 1]])
    geometry.setAttribute(name, new BufferAttribute(Float32Array.from(numbers), size));
  return geometry;
}

/**
 * Counts; see ExactShadows.sunHours(). `casters`: the Casters whose meshes cast; null if there was no picture yet.
 */
export async function sunHours(object, casters, options) {
  if (!casters) throw new Error('sunHours() needs a render() before it, whose meshes cast.');
  if (!object?.isObject3D) fail('object must be a mesh, or with a grid any object of the scene');
  const { signal } = options;
  signal?.throwIfAborted();
  const days = daysOf(options);
  object.updateWorldMatrix(true, true);
  const result = await workOn(taskOf(object, casters, options, days), options);
  const hoursOf = (count) => (count * days.step) / 60;
  const { positions, counts } = result;
  const told = { positions, possible: hoursOf(positions), counts };
  const hours = Float32Array.from(counts, hoursOf);
  if (options.grid === undefined) return { ...told, hours: new BufferAttribute(hours, 1) };
  const { points, normals, areas, states, corners } = result;
  const origin = new Vector3(...corners.subarray(0, 3));
  return { ...told, geometry: geometryOf(result, hours, origin), origin,
    cells: { points, normals, areas, hours, leftOut: states } };
}
