// The package: its contents and its size.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { missing, packedInto } from './support/package.mjs';
import { repository } from './support/server.mjs';

const site = join(repository, 'build/web');
const skip = missing('esbuild');
const description = JSON.parse(readFileSync(join(repository, 'web/package.json'), 'utf8'));

test('the version is that of the program', () => {
  const cmake = readFileSync(join(repository, 'CMakeLists.txt'), 'utf8');
  assert.equal(description.version, /project\(edgeshade VERSION ([\d.]+)/.exec(cmake)[1]);
});

test('every entry exports the version', async () => {
  assert.equal((await import(join(site, 'element/version.js'))).version, description.version);
  assert.equal((await import(join(site, 'masks/shadow-masks.js'))).version, description.version);
  for (const entry of ['element/edgeshade-viewer.js', 'three/exact-shadows.js', 'three-webgpu/exact-shadows.js'])
    assert.match(readFileSync(join(site, entry), 'utf8'), /^export \{ version \} from '.*\/version\.js';$/m, entry);
});

test('WebAssembly and JavaScript together weigh at most 855 KB, compressed', () => {
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
  assert.ok(total <= 855e3, `${total} bytes`);
});

/** The files that npm packs; `text(path)` and `weight(path, …)` read them. */
const packed = (() => {
  if (skip) return null;
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-pack-'));
  try {
    const told = packedInto(folder);
    execFileSync('tar', ['-xf', told.filename], { cwd: folder });
    const bytes = new Map(told.files.map(({ path }) => [path, readFileSync(join(folder, 'package', path))]));
    return { ...told, paths: [...bytes.keys()], text: (path) => bytes.get(path).toString(),
      weight: (...paths) => paths.reduce((sum, path) => sum + gzipSync(bytes.get(path), { level: 9 }).length, 0) };
  } finally {
    rmSync(folder, { recursive: true });
  }
})();

test('the package is at most 1.73 MB, 4.64 MB unpacked', { skip }, () => {
  const { size, unpackedSize } = packed;
  console.log(`tarball ${size} bytes, unpacked ${unpackedSize}`);
  assert.ok(size <= 1.73e6 && unpackedSize <= 4.64e6);
});

test('three.js\' adapter weighs at most 506 KB, its hours of sun 172 KB more when asked for, the element 822 KB, without a bundler, compressed', { skip }, () => {
  const modules = (...folders) => packed.paths.filter((path) => path.endsWith('.js') && folders.some((folder) => path.startsWith(`dist/${folder}/`)));
  const wasm = (name) => [`dist/wasm/${name}.wasm`, `dist/wasm/${name}.mjs`];
  const ofHours = (path) => path.includes('/sun-hours');
  const adapter = packed.weight(...wasm('edgeshade-masks'), 'dist/element/webassembly.js', ...modules('masks', 'three').filter((path) => !ofHours(path)));
  const hours = packed.weight(...wasm('edgeshade-hours'), ...modules('three').filter(ofHours));
  const element = packed.weight(...wasm('edgeshade'), ...modules('element'));
  console.log(`adapter ${adapter} bytes, hours ${hours}, element ${element}`);
  assert.ok(adapter <= 506e3 && hours <= 172e3 && element <= 822e3);
});

test('npm packs every entry with its types, workers and WebAssembly', { skip }, () => {
  assert.equal(`${packed.name}@${packed.version}`, `edgeshade@${description.version}`);
  const entries = Object.values(description.exports).flatMap((entry) => (typeof entry === 'string' ? entry : Object.values(entry)));
  for (const wanted of [...entries.map((path) => path.replace('./', '')), 'dist/element/scene-worker.js', 'dist/element/map-worker.js',
    'dist/masks/mesh-worker.js', 'dist/wasm/edgeshade.mjs', 'dist/wasm/edgeshade.wasm', 'dist/wasm/edgeshade-masks.mjs',
    'dist/wasm/edgeshade-masks.wasm', 'dist/three/sun-hours-worker.js', 'dist/wasm/edgeshade-hours.mjs', 'dist/wasm/edgeshade-hours.wasm', 'README.md', 'LICENSE', 'LICENSE.erfa', 'LICENSE.glu'])
    assert.ok(packed.paths.includes(wanted), `${wanted} is in it`);
  for (const path of packed.paths) assert.match(path, /^(package\.json|README\.md|LICENSE(\.(erfa|glu))?|dist\/(element|masks|three|three-webgpu|wasm)\/[^/]+)$/);
});

test('every module has a map that holds its source', { skip }, () => {
  const modules = packed.paths.filter((path) => path.endsWith('.js'));
  assert.ok(modules.length > 30, `${modules.length} modules`);
  for (const path of modules) {
    assert.ok(packed.text(path).endsWith(`//# sourceMappingURL=${basename(path)}.map\n`), path);
    const { sources, sourcesContent, mappings } = JSON.parse(packed.text(`${path}.map`));
    const source = path.replace('dist/', '');
    assert.deepEqual(sources, [`../../${source}`]);
    assert.equal(sourcesContent[0], readFileSync(join(site, source), 'utf8'));
    assert.ok(mappings.length > 0);
  }
});

test('nothing names a server: no address in the page goes elsewhere', () => {
  for (const folder of ['', 'element', 'examples', 'masks', 'three', 'three-webgpu', 'page'])
    for (const file of readdirSync(join(site, folder)).filter((entry) => /\.(js|css|html)$/.test(entry)))
      assert.doesNotMatch(readFileSync(join(site, folder, file), 'utf8').replaceAll('http://www.w3.org', ''),
        /https?:\/\/(?!localhost)/, `${folder}/${file}`);
});
