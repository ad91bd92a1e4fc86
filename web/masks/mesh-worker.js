// The worker that finds meshes' edges. It passes the page buffers that only need copying.

import { withMesh } from './numbers.js';
import { instantiate } from './runtime.js';

let packer = null;

async function pack({ number, module, mesh }) {
  packer ??= instantiate(module).then((program) => ({ program, packer: new program.MeshPacker() }));
  const { program, packer: by } = await packer;
  const problem = withMesh(program, mesh, (...numbers) => by.pack(...numbers));
  if (problem) throw new Error(problem);
  const bytes = by.bytes().slice();
  postMessage({ number, result: bytes }, [bytes.buffer]);
}

onmessage = ({ data }) =>
  pack(data).catch((error) => postMessage({ number: data.number, problem: error.message }));
