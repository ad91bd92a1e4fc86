// The WebAssembly module: compiled once a page, an instance of its own for every element and for
// every worker.

import createModule from '../wasm/edgeshade.mjs';

let compiled = null;

/** The compiled module; fetched and compiled at the first call. */
export function compiledModule() {
  compiled ??= compile().catch((error) => {
    compiled = null; // so that the next call tries again
    throw error;
  });
  return compiled;
}

async function compile() {
  const address = new URL('../wasm/edgeshade.wasm', import.meta.url);
  let response;
  try {
    response = await fetch(address);
  } catch {
    throw new Error('The viewer\'s program could not be fetched. Is there a connection?');
  }
  if (!response.ok)
    throw new Error(`The viewer's program could not be fetched: the server said ${response.status}.`);
  try {
    return await WebAssembly.compile(await response.arrayBuffer());
  } catch {
    throw new Error('This browser is too old for the viewer: it can\'t run its WebAssembly.');
  }
}

/** An instance of the compiled module. */
export function instantiate(module) {
  return createModule({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance));
      return {};
    },
  });
}
