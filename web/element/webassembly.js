// WebAssembly programs; each is compiled once per page.

/** Returns a function that returns the compiled module at an address; its first call fetches and
 * compiles it. `who`: the program's name in messages to the user. */
export function compiledOnce(address, who) {
  let compiled = null;
  return () => {
    compiled ??= compile(address, who).catch((error) => {
      compiled = null; // so that the next call tries again
      throw error;
    });
    return compiled;
  };
}

async function compile(address, who) {
  let response;
  try {
    response = await fetch(address);
  } catch {
    throw new Error(`The ${who}'s program could not be fetched. Is there a connection?`);
  }
  if (!response.ok)
    throw new Error(`The ${who}'s program could not be fetched: ` +
      `the server answered ${response.status}.`);
  try {
    return await WebAssembly.compile(await response.arrayBuffer());
  } catch {
    throw new Error(`This browser is too old for the ${who}: it can't run its WebAssembly.`);
  }
}

/** An instance of a compiled module, started by Emscripten's own function. */
export function instantiateBy(createModule, module) {
  return createModule({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance));
      return {};
    },
  });
}
