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

/** Adds a mesh at all of its places. */
function add(program, counter, { positions, indices, places, casts, measured }) {
  check(withCopies(program, [positions, indices], ([p, i]) => counter.addMesh(p, positions.length, i, indices.length)));
  for (let at = 0; at < places.length; at += 16)
    check(withCopies(program, [places.subarray(at, at + 16)], ([matrix]) => counter.place(matrix, casts, measured)));
}

const cellNames = ['points', 'normals', 'areas', 'states', 'faceCounts', 'cornerCounts', 'corners'];

async function measure({ days, meshes, normals, grid, offset }) {
  const program = await instantiateBy(createModule, await compiledModule());
  const counter = new program.HoursCounter();
  setPositions(program, counter, days);
  for (const mesh of meshes) add(program, counter, mesh);
  check(normals ? withCopies(program, [normals], ([address]) => counter.measureVertices(address)) : counter.measureCells(grid, offset));
  while (!counter.advance()) postMessage({ share: counter.share() });
  check(counter.problem());
  const result = { positions: counter.positions(), counts: counter.counts().slice() };
  for (const name of normals ? [] : cellNames) result[name] = counter[name]().slice();
  postMessage({ result });
}

onmessage = ({ data }) => measure(data).catch(({ message }) => postMessage({ problem: message }));
