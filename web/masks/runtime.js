// The mask engine's program: a separate instance for every context and every worker.

import createModule from '../wasm/edgeshade-masks.mjs';
import { compiledOnce, instantiateBy } from '../element/webassembly.js';

export const compiledModule = compiledOnce(new URL('../wasm/edgeshade-masks.wasm', import.meta.url), 'shadows');
export const instantiate = (module) => instantiateBy(createModule, module);
