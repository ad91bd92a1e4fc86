// Before `npm pack`: makes dist/, all that is packed but package.json and README.md. Modules are minified one by
// one, so that bundlers see them as they are, with maps beside them that hold their sources; the WebAssembly is
// that of ../build/web, where CMake has put it.

import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(`../${path}`, import.meta.url));
const built = '../build/web/wasm';

function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}

if (!existsSync(at(`${built}/edgeshade.wasm`))) fail('There is no WebAssembly to pack yet: ./run web --build-only builds it.');
const { transform } = await import('esbuild').catch(() => fail("esbuild is not installed: 'npm ci' in web/ does that."));
const settings = { minify: true, format: 'esm', target: 'es2022', legalComments: 'none' };

/** A module of ours: its source's address is beside the package's, the map has the text. */
async function minify(folder, name) {
  const { code, map } = await transform(readFileSync(at(`${folder}/${name}`), 'utf8'),
    { ...settings, sourcefile: `../../${folder}/${name}`, sourcemap: 'external' });
  writeFileSync(at(`dist/${folder}/${name}`), `${code}//# sourceMappingURL=${name}.map\n`);
  writeFileSync(at(`dist/${folder}/${name}.map`), map);
}

rmSync(at('dist'), { recursive: true, force: true });
for (const folder of ['element', 'masks', 'three']) {
  mkdirSync(at(`dist/${folder}`), { recursive: true });
  for (const name of readdirSync(at(folder)))
    if (name.endsWith('.d.ts')) cpSync(at(`${folder}/${name}`), at(`dist/${folder}/${name}`));
    else if (name.endsWith('.js')) await minify(folder, name);
}
mkdirSync(at('dist/wasm'));
for (const name of ['edgeshade', 'edgeshade-masks']) {
  cpSync(at(`${built}/${name}.wasm`), at(`dist/wasm/${name}.wasm`));
  // Emscripten's; nobody wrote a source that a map could show.
  const { code } = await transform(readFileSync(at(`${built}/${name}.mjs`), 'utf8'), settings);
  writeFileSync(at(`dist/wasm/${name}.mjs`), code);
}
cpSync(at('../LICENSE'), at('LICENSE'));
cpSync(at('../build/web/LICENSE.erfa'), at('LICENSE.erfa'));
