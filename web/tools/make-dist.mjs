// Runs before `npm pack`: makes dist/ from ../build/web, where CMake has put all files that are
// served. Modules are minified one by one, so that bundlers still see them as modules, with source
// maps beside them.

import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('..', import.meta.url));
const [built, dist] = [`${here}../build/web`, `${here}dist`];

function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}

if (!existsSync(`${built}/wasm/edgeshade-masks.wasm`)) fail('There is nothing to pack yet: ./run web --build-only builds it.');
const { transform } = await import('esbuild').catch(() => fail("esbuild is not installed: 'npm ci' in web/ does that."));
const settings = { minify: true, format: 'esm', target: 'es2022', legalComments: 'none' };

/** How files get into dist/, by extension; others are left out. */
const ways = {
  '.d.ts': (file) => cpSync(`${built}/${file}`, `${dist}/${file}`),
  async '.js'(file) {
    const { code, map } = await transform(readFileSync(`${built}/${file}`, 'utf8'),
      { ...settings, sourcefile: `../../${file}`, sourcemap: 'external' });
    writeFileSync(`${dist}/${file}`, `${code}//# sourceMappingURL=${file.split('/').at(-1)}.map\n`);
    writeFileSync(`${dist}/${file}.map`, map);
  },
  // Emscripten generated it, so there is no source for a source map.
  async '.mjs'(file) {
    writeFileSync(`${dist}/${file}`, (await transform(readFileSync(`${built}/${file}`, 'utf8'), settings)).code);
  },
  // Copied by content, since linkers make the file executable.
  '.wasm': (file) => writeFileSync(`${dist}/${file}`, readFileSync(`${built}/${file}`)),
};

rmSync(dist, { recursive: true, force: true });
for (const folder of ['element', 'masks', 'three', 'three-webgpu', 'wasm']) {
  mkdirSync(`${dist}/${folder}`, { recursive: true });
  for (const name of readdirSync(`${built}/${folder}`))
    await Object.entries(ways).find(([end]) => name.endsWith(end))?.[1](`${folder}/${name}`);
}
for (const licence of ['LICENSE', 'LICENSE.erfa', 'LICENSE.glu']) cpSync(`${built}/${licence}`, here + licence);
