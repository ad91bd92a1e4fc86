// The worker that counts hours of sun by rays: one task, then the page ends it.

import createModule from '../wasm/edgeshade-hours.mjs';
import { compiledOnce, instantiateBy } from '../element/webassembly.js';
import { withCopies } from '../masks/numbers.js';

const compiledModule = compiledOnce(new URL('../wasm/edgeshade-hours.wasm', import.meta.url), 'hours of sun');

/** Throws a sentence, unless it is empty. */
function check(problem) {
  if (problem) throw new Error(problem);
}

function setPositions(program, counter, { place, from, to, times, step, hours, utcOffset, minAltitude, north }) {
  check(times
    ? withCopies(program, [times], ([seconds]) => counter.setTimes(...place, seconds, times.length, minAltitude, north))
    : counter.setDays(...place, from, to, utcOffset, step, ...hours, minAltitude, north));
}

/** GL's enums. */
const wraps = { repeat: 10497, mirror: 33648, clamp: 33071 }, filters = { nearest: 9728, linear: 9729 };

/** `texels`: all textures' that cut casters out, as ShadowMasks.addTexels() takes them. */
function setAlpha(program, counter, { opacity, cutoff, texels: index, texcoords }, texels) {
  const { wrapS = 'repeat', wrapT = 'repeat', filter = 'linear' } = texels[index] ?? {};
  check(withCopies(program, [texcoords], ([at]) => counter.setAlpha(opacity, cutoff, index, at, wraps[wrapS], wraps[wrapT], filters[filter])));
}

/** Adds a mesh at all of its places. */
function add(program, counter, { positions, indices, places, casts, measured, alpha, clippings = [] }, texels) {
  check(withCopies(program, [positions, indices], ([p, i]) => counter.addMesh(p, positions.length, i, indices.length)));
  if (alpha) setAlpha(program, counter, alpha, texels);
  for (const { planes, intersection } of clippings)
    check(withCopies(program, [Float64Array.from(planes.flat())], ([at]) => counter.addClipping(at, planes.length, Boolean(intersection))));
  for (let at = 0; at < places.length; at += 16)
    check(withCopies(program, [places.subarray(at, at + 16)], ([matrix]) => counter.place(matrix, casts, measured)));
}

const cellNames = ['points', 'normals', 'areas', 'states', 'faceCounts', 'cornerCounts', 'corners'];

async function measure({ days, texels, meshes, normals, grid, offset }) {
  const program = await instantiateBy(createModule, await compiledModule());
  const counter = new program.HoursCounter();
  setPositions(program, counter, days);
  for (const { alpha, width, height } of texels) check(withCopies(program, [alpha], ([at]) => counter.addTexels(at, alpha.length, width, height)));
  for (const mesh of meshes) add(program, counter, mesh, texels);
  check(normals ? withCopies(program, [normals], ([address]) => counter.measureVertices(address)) : counter.measureCells(grid, offset));
  while (!counter.advance()) postMessage({ share: counter.share() });
  check(counter.problem());
  const result = { positions: counter.positions(), counts: counter.counts().slice() };
  for (const name of normals ? [] : cellNames) result[name] = counter[name]().slice();
  postMessage({ result });
}

onmessage = ({ data }) => measure(data).catch(({ message }) => postMessage({ problem: message }));
