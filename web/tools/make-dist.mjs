// Before `npm pack`: makes dist/ of ../build/web, where CMake has put all that is served. Modules are minified one by
// one, so that bundlers see them as they are, with maps beside them that hold their sources.

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

/** How files get into dist/, by their ends; others don't. */
const ways = {
  '.d.ts': (file) => cpSync(`${built}/${file}`, `${dist}/${file}`),
  async '.js'(file) {
    const { code, map } = await transform(readFileSync(`${built}/${file}`, 'utf8'),
      { ...settings, sourcefile: `../../${file}`, sourcemap: 'external' });
    writeFileSync(`${dist}/${file}`, `${code}//# sourceMappingURL=${file.split('/').at(-1)}.map\n`);
    writeFileSync(`${dist}/${file}.map`, map);
  },
  // Emscripten's; nobody wrote a source that a map could show.
  async '.mjs'(file) {
    writeFileSync(`${dist}/${file}`, (await transform(readFileSync(`${built}/${file}`, 'utf8'), settings)).code);
  },
  // Not executable, as linkers leave it.
  '.wasm': (file) => writeFileSync(`${dist}/${file}`, readFileSync(`${built}/${file}`)),
};

rmSync(dist, { recursive: true, force: true });
for (const folder of ['element', 'masks', 'three', 'wasm']) {
  mkdirSync(`${dist}/${folder}`, { recursive: true });
  for (const name of readdirSync(`${built}/${folder}`))
    await Object.entries(ways).find(([end]) => name.endsWith(end))?.[1](`${folder}/${name}`);
}
for (const licence of ['LICENSE', 'LICENSE.erfa']) cpSync(`${built}/${licence}`, here + licence);
