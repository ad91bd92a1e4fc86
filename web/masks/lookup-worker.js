// The worker that builds the maps of resting lights, one after another.

import { turns } from '../element/event-loop.js';
import { putParts } from '../element/memory.js';
import { instantiate } from './runtime.js';

/** Milliseconds of work between checks whether the task is still wanted. */
const slice = 20;

let ready = null; // a promise of {program, maker}
let last = Promise.resolve();
const asked = new Set(); // numbers

const messages = turns();

async function build({ number, task }) {
  const { program, maker } = await ready;
  if (!asked.has(number)) return;
  const problem = maker.begin(...putParts(program, task));
  if (problem) throw new Error(problem);
  while (!maker.advance(slice)) {
    await messages();
    if (!asked.has(number)) return;
  }
  const bytes = maker.result().slice();
  if (bytes.length === 0) throw new Error('The map of a light took too much memory.');
  const texels = maker.texels().slice();
  postMessage({ number, result: { bytes, texels } }, [bytes.buffer, texels.buffer]);
}

onmessage = ({ data }) => {
  if (data.module) ready ??= instantiate(data.module).then((program) => ({ program, maker: new program.LookupMaker() }));
  if (!data.task) {
    asked.delete(data.number);
    return;
  }
  asked.add(data.number);
  last = last.then(() => build(data)).catch((error) => postMessage({ number: data.number, problem: error.message }))
    .finally(() => asked.delete(data.number));
};
