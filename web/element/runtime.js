// The viewer's program: a separate instance for every element and every worker.

import createModule from '../wasm/edgeshade.mjs';
import { compiledOnce, instantiateBy } from './webassembly.js';

export const compiledModule = compiledOnce(new URL('../wasm/edgeshade.wasm', import.meta.url), 'viewer');
export const instantiate = (module) => instantiateBy(createModule, module);
