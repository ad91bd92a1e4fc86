// Before `npm pack`: takes the built WebAssembly from ../build/web, where CMake has put it.

import { copyFileSync, existsSync, mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
if (existsSync(at('../../build/web/wasm/edgeshade.wasm'))) {
  mkdirSync(at('../wasm'), { recursive: true });
  for (const file of ['edgeshade.mjs', 'edgeshade.wasm', 'edgeshade-masks.mjs', 'edgeshade-masks.wasm'])
    copyFileSync(at(`../../build/web/wasm/${file}`), at(`../wasm/${file}`));
} else if (!existsSync(at('../wasm/edgeshade.wasm'))) {
  console.error('There is no WebAssembly to pack yet: ./run web --build-only builds it.');
  process.exit(1);
}
