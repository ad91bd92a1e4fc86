// The worker that builds primitive maps of one scene, one at a time.

import { turns } from './event-loop.js';
import { putBytes } from './memory.js';
import { instantiate } from './runtime.js';

/** Milliseconds of work between checks for another task. */
const slice = 20;

let maker = null; // a promise of {program, made}
let take = null;
const ready = new Promise((resolve) => { take = resolve; });
let wanted = 0; // the ticket of the current task, 0: none

const messages = turns();

async function prepare({ module, scene }) {
  const [program, bytes] = await Promise.all([instantiate(module), scene.arrayBuffer()]);
  const made = new program.MapMaker();
  const problem = made.show(...putBytes(program, new Uint8Array(bytes)));
  if (problem) throw new Error(problem);
  return { program, made };
}

async function make(ticket, task) {
  const { program, made } = await (maker ??= ready.then(prepare));
  if (ticket !== wanted) return;
  const problem = made.begin(...putBytes(program, task));
  if (problem) throw new Error(problem);
  while (!made.advance(slice)) {
    await messages();
    if (ticket !== wanted) return;
  }
  const map = made.result().slice();
  if (map.byteLength === 0) throw new Error('The map took too much memory.');
  postMessage({ ticket, map }, [map.buffer]);
}

onmessage = ({ data }) => {
  if (data.module) return take(data);
  wanted = data.ticket;
  if (data.task) make(data.ticket, data.task).catch(() => postMessage({ failed: true }));
};
