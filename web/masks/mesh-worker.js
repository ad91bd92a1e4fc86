// The worker that finds meshes' edges, and merges small neighbours. It passes the page buffers that
// only need copying.

import { withCopies, withMesh } from './numbers.js';
import { instantiate } from './runtime.js';

let ready = null; // a promise of {program, packer}

async function pack({ number, module, meshes, placed, matrices }) {
  ready ??= instantiate(module).then((program) => ({ program, packer: new program.MeshPacker() }));
  const { program, packer } = await ready;
  packer.clear();
  const packed = meshes.map((mesh) => withMesh(program, mesh, (...numbers) => packer.pack(...numbers)) || packer.bytes().slice());
  const problem = withCopies(program, [placed, matrices], (addresses) => packer.merge(...addresses, placed.length));
  if (problem) throw new Error(problem);
  const merged = Array.from({ length: packer.mergedCount() }, (_, i) => ({ members: [...packer.members(i)], bytes: packer.mergedBytes(i).slice() }));
  const buffers = [...packed, ...merged.map(({ bytes }) => bytes)].map(({ buffer }) => buffer).filter(Boolean);
  postMessage({ number, result: { meshes: packed, merged } }, buffers);
}

onmessage = ({ data }) =>
  pack(data).catch((error) => postMessage({ number: data.number, problem: error.message }));
