// The package: what is in it, what it weighs.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { repository } from './support/server.mjs';

const site = join(repository, 'build/web');
const description = JSON.parse(readFileSync(join(repository, 'web/package.json'), 'utf8'));

test('the version is that of the program', () => {
  const cmake = readFileSync(join(repository, 'CMakeLists.txt'), 'utf8');
  assert.equal(description.version, /project\(edgeshade VERSION ([\d.]+)/.exec(cmake)[1]);
});

test('WebAssembly and JavaScript together weigh at most 800 KB, compressed', () => {
  const parts = {};
  const add = (part, path) => {
    parts[part] = (parts[part] ?? 0) + gzipSync(readFileSync(path), { level: 9 }).length;
  };
  add('wasm', join(site, 'wasm/edgeshade.wasm'));
  add('glue', join(site, 'wasm/edgeshade.mjs'));
  for (const folder of ['element', 'page'])
    for (const file of readdirSync(join(site, folder)))
      if (file.endsWith('.js')) add(folder, join(site, folder, file));
  console.log(parts);
  const total = Object.values(parts).reduce((sum, part) => sum + part, 0);
  assert.ok(total <= 800e3, `${total} bytes`);
});

test('three.js\' adapter weighs at most 420 KB, compressed', () => {
  let total = 0;
  for (const file of ['wasm/edgeshade-masks.wasm', 'wasm/edgeshade-masks.mjs', 'element/webassembly.js',
    ...['masks', 'three'].flatMap((folder) => readdirSync(join(site, folder)).map((name) => `${folder}/${name}`)).filter((name) => name.endsWith('.js'))])
    total += gzipSync(readFileSync(join(site, file)), { level: 9 }).length;
  console.log(`${total} bytes`);
  assert.ok(total <= 420e3, `${total} bytes`);
});

test('npm packs the element, its types and its WebAssembly', () => {
  const [{ files, name, version }] = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json', '--loglevel', 'error'],
    { cwd: site, encoding: 'utf8' }));
  assert.equal(`${name}@${version}`, `edgeshade@${description.version}`);
  const paths = files.map(({ path }) => path);
  for (const wanted of ['element/edgeshade-viewer.js', 'element/edgeshade-viewer.d.ts', 'element/scene-worker.js',
    'three/exact-shadows.js', 'three/exact-shadows.d.ts', 'masks/shadow-masks.js', 'masks/shadow-masks.d.ts', 'masks/mesh-worker.js',
    'wasm/edgeshade.mjs', 'wasm/edgeshade.wasm', 'wasm/edgeshade-masks.mjs', 'wasm/edgeshade-masks.wasm', 'package.json', 'README.md', 'LICENSE', 'LICENSE.erfa'])
    assert.ok(paths.includes(wanted), `${wanted} is in it`);
  assert.ok(!paths.some((path) => path.startsWith('page/') || /\.[ch]pp$/.test(path) || path.startsWith('tests/')));
});

test('nothing names a server: no address in the page goes elsewhere', () => {
  for (const folder of ['', 'element', 'masks', 'three', 'page'])
    for (const file of readdirSync(join(site, folder)).filter((entry) => /\.(js|css|html)$/.test(entry)))
      assert.doesNotMatch(readFileSync(join(site, folder, file), 'utf8').replaceAll('http://www.w3.org', ''),
        /https?:\/\/(?!localhost)/, `${folder}/${file}`);
});
