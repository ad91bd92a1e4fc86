// The viewer's program: an instance of its own for every element and for every worker.

import createModule from '../wasm/edgeshade.mjs';
import { compiledOnce, instantiateBy } from './webassembly.js';

export const compiledModule = compiledOnce(new URL('../wasm/edgeshade.wasm', import.meta.url), 'viewer');
export const instantiate = (module) => instantiateBy(createModule, module);
