// The package as bundlers and compilers use it: a page gets only what it imports, within limits on
// its size, and has types.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { installIn, missing, modules } from './support/package.mjs';

const folder = mkdtempSync(join(tmpdir(), 'edgeshade-bundled-'));
const skip = missing('esbuild', 'vite', 'three');
before(() => skip || installIn(folder));
after(() => rmSync(folder, { recursive: true }));

/** A module's path in dist/; '' for others. */
const place = (path) => path.split('edgeshade/dist/')[1] ?? '';
const left = (parts, bytes) => Object.keys(parts).filter((path) => parts[path][bytes] > 0).map(place).filter(Boolean);

/** Bundlers. Each takes a page's script, without three.js, and returns {code, modules, files}:
 * the package's modules of which something is left, and [name, contents] of all files that are
 * served. */
const bundlers = {
  async esbuild(script, beside = []) {
    const { build } = await import('esbuild');
    writeFileSync(join(folder, 'page.js'), script);
    const { outputFiles, metafile: { outputs } } = await build({ absWorkingDir: folder, outdir: '.', write: false, metafile: true,
      entryPoints: ['page.js', ...beside.map((path) => `node_modules/edgeshade/dist/${path}`)], entryNames: 'out/[name]',
      bundle: true, minify: true, format: 'esm', loader: { '.wasm': 'copy' }, external: ['three'], logLevel: 'error' });
    const files = outputFiles.map(({ path, contents }) => [basename(path), contents]);
    return { code: outputFiles[0].text, modules: left(outputs['out/page.js'].inputs, 'bytesInOutput'), files };
  },
  async Vite(script) {
    const { build } = await import('vite');
    writeFileSync(join(folder, 'page.js'), script);
    const { output } = await build({ root: folder, configFile: false, logLevel: 'error',
      build: { write: false, modulePreload: false, rolldownOptions: { input: join(folder, 'page.js'), external: /^three($|\/)/ } } });
    const [{ code, modules: parts }] = output;
    return { code, modules: left(parts, 'renderedLength'),
      files: output.map((file) => [basename(file.fileName), file.code ?? file.source]) };
  },
};

/** By entry: a page's script, a string of the entry's own modules that survives minifying, the
 * folders from which it may take modules (its own, and others' of which `parts` has only some), and its
 * program. */
const entries = {
  three: { script: "import { ExactShadows } from 'edgeshade/three'; window.use = ExactShadows;", mark: 'edgeshadeNearness',
    folders: ['three', 'masks'], program: 'edgeshade-masks' },
  'three-webgpu': { script: "import { ExactShadows } from 'edgeshade/three-webgpu'; window.use = ExactShadows;", mark: 'edgeshadeAtLeastZero',
    folders: ['three-webgpu', 'three', 'masks'], parts: ['three'], program: 'edgeshade-masks' },
  masks: { script: "import { ShadowMasks } from 'edgeshade/masks'; window.use = ShadowMasks;", mark: 'mesh-worker',
    folders: ['masks'], program: 'edgeshade-masks' },
  element: { script: "import 'edgeshade';", mark: '<canvas', folders: ['element'], program: 'edgeshade' },
};

for (const [bundler, bundle] of Object.entries(bundlers)) {
  test(`${bundler} takes what is imported, and nothing of the other entries`, { skip }, async () => {
    for (const [name, { script, folders, parts = [], program }] of Object.entries(entries)) {
      const { code, modules: taken } = await bundle(script);
      const others = taken.filter((path) => !folders.includes(path.split('/')[0]));
      const shared = [...(folders.includes('element') ? [] : ['element/memory.js', 'element/webassembly.js']), `wasm/${program}.mjs`];
      assert.deepEqual(others.sort(), shared, name);
      for (const [other, { mark }] of Object.entries(entries))
        assert.equal(code.includes(mark), folders.includes(other) && !parts.includes(other), `${name}: ${mark} of ${other}`);
    }
  });

  test(`${bundler} drops what isn't used`, { skip }, async () => {
    const { code, modules: taken } = await bundle("import { ExactShadows } from 'edgeshade/three'; import { ShadowMasks } from 'edgeshade/masks'; window.used = 1;");
    assert.deepEqual(taken, []);
    assert.ok(code.length < 100, code);
  });

  // esbuild without --splitting puts hours of sun into the page's script; Vite loads them when they are asked for.
  const [mostWithNodes, mostKb] = bundler === 'Vite' ? [48, 56] : [52, 60];
  test(`a page of ${bundler} has at most ${mostWithNodes} KB of scripts by edgeshade/three-webgpu, compressed`, { skip }, async () => {
    const { files: [[, code]] } = await bundle(entries['three-webgpu'].script);
    const compressed = gzipSync(code, { level: 9 }).length;
    console.log(bundler, { bytes: code.length, compressed });
    assert.ok(compressed <= 1000 * mostWithNodes, `${compressed} bytes`);
  });

  test(`a page of ${bundler} has at most ${mostKb} KB of scripts by edgeshade/three, compressed, and 20 KB in each worker`, { skip }, async () => {
    const dist = join(folder, 'node_modules/edgeshade/dist');
    const workers = ['masks', 'three'].flatMap((part) => readdirSync(join(dist, part)).filter((name) => name.endsWith('-worker.js')).map((name) => `${part}/${name}`));
    const programs = ['wasm/edgeshade-masks.wasm', 'wasm/edgeshade-hours.wasm'];
    const { files } = await bundle(entries.three.script, [...workers, ...programs]);
    const sizes = files.map(([name, contents]) => ({ name, bytes: Buffer.from(contents).length, compressed: gzipSync(contents, { level: 9 }).length }));
    console.log(bundler, sizes);
    const most = ({ name }) => (/edgeshade-hours.*wasm$/.test(name) ? 157e3 : name.endsWith('.wasm') ? Infinity :
      name.includes('worker') ? 20e3 : name.startsWith('sun-hours') ? 3e3 : mostKb * 1e3);
    for (const one of sizes) assert.ok(one.compressed <= most(one), one.name);
    assert.equal(sizes.length, 1 + workers.length + programs.length + (bundler === 'Vite' ? 1 : 0));
  });
}

test('every entry has its types, by the rules of Node.js', { skip: skip || missing('typescript') }, () => {
  writeFileSync(join(folder, 'page.ts'), `import { hourColors, type EdgeshadeViewer } from 'edgeshade';
import { ShadowMasks, type MaskMesh } from 'edgeshade/masks';
import { ExactShadows } from 'edgeshade/three';
import { ExactShadows as NodeShadows, type LightShadow } from 'edgeshade/three-webgpu';
export const viewer: EdgeshadeViewer = document.createElement('edgeshade-viewer');
export const mesh: MaskMesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] };
export const masks: Promise<ShadowMasks> = ShadowMasks.create(document.createElement('canvas').getContext('webgl')!);
export const onDemand = async (shadows: ExactShadows, ask: () => void): Promise<boolean> => {
  shadows.addEventListener('change', ask);
  await shadows.settled;
  return shadows.needsUpdate;
};
export const hours = async (shadows: ExactShadows): Promise<number> => {
  const { counts, possible } = await shadows.sunHours(1 as never, { place: [48, 11], date: '2026-03-21' });
  const { cells } = await shadows.sunHours(1 as never, { place: [48, 11], times: [new Date(0)], grid: 1, signal: AbortSignal.timeout(9) });
  return counts[0] + cells.hours[0] + possible;
};
// @ts-expect-error: sun positions need a place
export const nowhere = (shadows: ExactShadows) => shadows.sunHours(1 as never, { date: '2026-03-21' });
export const bytes = (shadows: ExactShadows): number | undefined => shadows.cost?.bytes;
export const methods = (shadows: NodeShadows): LightShadow['method'][] => shadows.lights.map(({ method }) => method);
export const cells = async (shadows: NodeShadows): Promise<Float64Array> => (await shadows.sunHours(1 as never, { place: [48, 11], date: '2026-03-21', grid: 1 })).cells.areas;
// @ts-expect-error: they have types, which are not any
export const wrong: boolean = [hourColors, new ExactShadows(1 as never).lightSamples];
`);
  const { stdout } = spawnSync(process.execPath, [join(modules, 'typescript/bin/tsc'), '--strict', '--noEmit', '--skipLibCheck',
    '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2022,dom', 'page.ts'], { cwd: folder, encoding: 'utf8' });
  assert.equal(stdout, '');
});
