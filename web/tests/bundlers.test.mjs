// The package as its users have it: installed from npm's tarball, with the README's lines for each
// entry in pages built by Vite, by esbuild, and without a bundler. The shadows must be in the right
// places.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { useBrowser } from './support/browser.mjs';
import { installIn, missing, modules } from './support/package.mjs';
import { blocksOf } from './support/readme.mjs';
import { smallGlb } from './support/scenes.mjs';

const folder = mkdtempSync(join(tmpdir(), 'edgeshade-packed-'));
const skip = missing('esbuild', 'vite', 'three');
const shared = useBrowser({ roots: { '/': `${folder}/` } });

/** Import map for pages without a bundler. */
const imports = {
  three: '/node_modules/three/build/three.module.js',
  edgeshade: '/node_modules/edgeshade/dist/element/edgeshade-viewer.js',
  'edgeshade/three': '/node_modules/edgeshade/dist/three/exact-shadows.js',
  'edgeshade/masks': '/node_modules/edgeshade/dist/masks/shadow-masks.js',
};
const importMap = `<script type="importmap">${JSON.stringify({ imports })}</script>`;

const [elementHtml] = blocksOf('`edgeshade`', 'html');
const [tag] = /<edgeshade-viewer[^]*<\/edgeshade-viewer>/.exec(elementHtml);

const lines = (entry) => blocksOf(`\`${entry}\``, 'js').join('\n');

/**
 * Each page's script: the README's lines, after the globals that they need and before the questions
 * of the test; its body.
 */
const pages = {
  three: {
    script: `import './three-world.js';\n${lines('edgeshade/three')}
window.mostHours = () => shadows.sunHours(scene.children[0], { place: [48, 11], date: '2026-03-21' }).then(({ hours }) => Math.max(...hours.array));`,
  },
  masks: {
    script: `import './masks-world.js';\n${lines('edgeshade/masks')}
window.shadowAndLight = () => shadowAndLightIn(textures[0]);`,
  },
  element: {
    script: `import './element-world.js';\nimport 'edgeshade';
await new Promise((resolve) => { document.querySelector('edgeshade-viewer').addEventListener('load', resolve, { once: true }); });
${lines('edgeshade')}
const seen = await shadowAndLightOf(viewer);
window.shadowAndLight = () => seen;`,
    body: tag.replace('house.glb', '/house.glb'),
  },
};

const html = (script, { head = '', body = '' } = {}) =>
  `<!DOCTYPE html><link rel="icon" href="data:,">${head}<body>${body}<script type="module" src="${script}"></script>`;

/** Writes a page of `pages` as `name`.html into a folder of the site. */
function write(where, name, script, extra) {
  mkdirSync(join(folder, where), { recursive: true });
  writeFileSync(join(folder, where, `${name}.html`), html(script, { ...extra, body: pages[name].body }));
}

before(() => {
  if (skip) return;
  installIn(folder);
  writeFileSync(join(folder, 'house.glb'), smallGlb());
  cpSync(fileURLToPath(new URL('pages/packed', import.meta.url)), folder, { recursive: true });
  for (const [name, { script }] of Object.entries(pages)) {
    writeFileSync(join(folder, `${name}.js`), script);
    write('.', name, `./${name}.js`);
  }
});
after(() => rmSync(folder, { recursive: true }));

/** Waits until one place in shadow is dark and one in light isn't. */
async function showsShadow(address) {
  const page = await shared.open(address, { scene: false, size: { width: 400, height: 300 } });
  await page.waitForFunction(() => {
    const [shadow, light] = window.shadowAndLight?.() ?? [];
    return shadow < 20 && light > 60;
  }, null, { timeout: 60000, polling: 50 }).catch(async () =>
    assert.fail(`${address}: ${await page.evaluate(() => window.shadowAndLight?.())} ${page.reports}`));
  const hours = await page.evaluate(() => window.mostHours?.() ?? 12);
  assert.ok(hours > 11 && hours < 13, `${address}: ${hours} hours of sun on the equinox`);
  await shared.check(page);
}

test('Vite: nothing is set up', { skip }, async () => {
  const { build } = await import('vite');
  for (const name of ['three', 'element']) {
    await build({ root: folder, base: './', configFile: false, logLevel: 'error',
      build: { outDir: `vite-${name}`, rolldownOptions: { input: join(folder, `${name}.html`) }, chunkSizeWarningLimit: 1e4 } });
    await showsShadow(`/vite-${name}/${name}.html`);
  }
});

test('Vite\'s server for development', { skip }, async () => {
  const { createServer } = await import('vite');
  const server = await createServer({ root: folder, configFile: false, logLevel: 'error', server: { port: 0, fs: { strict: false } } });
  try {
    await server.listen();
    await showsShadow(new URL('three.html', server.resolvedUrls.local[0]).href);
  } finally {
    await server.close();
  }
});

test('esbuild, by the README\'s command', { skip }, async () => {
  const [command] = blocksOf('Bundlers', 'sh');
  const PATH = `${join(modules, '.bin')}:${process.env.PATH}`;
  for (const name of ['three', 'element']) {
    let own = command.replace('page.js', `${name}.js --log-level=error`).replaceAll('site/', `esbuild-${name}/`);
    if (name === 'three') // as the README says for sunHours()
      own = own.replace('$dist/masks/*-worker.js', '$& $dist/three/*-worker.js').replace('$dist/wasm/edgeshade-masks.wasm', '$& $dist/wasm/edgeshade-hours.wasm');
    if (name === 'element') own = own.replace('masks/*-worker', 'element/*-worker').replace('edgeshade-masks', 'edgeshade');
    execFileSync('sh', ['-euc', own], { cwd: folder, env: { ...process.env, PATH } });
    write(`esbuild-${name}`, name, `./js/${name}.js`);
    await showsShadow(`/esbuild-${name}/${name}.html`);
  }
});

test('what a bundle doesn\'t find is said', { skip }, async () => {
  const { build } = await import('esbuild');
  const contents = `${pages.three.script}\nshadows.ready().catch((error) => { window.problem = error.message; });`;
  await build({ stdin: { contents, resolveDir: folder }, bundle: true, format: 'esm', outfile: join(folder, 'alone/js/page.js') });
  write('alone', 'three', './js/page.js');
  const problem = async () => {
    const page = await shared.open('/alone/three.html', { scene: false });
    const sentence = await (await page.waitForFunction(() => window.problem)).jsonValue();
    await shared.check(page, [/404/]);
    return sentence;
  };
  assert.match(await problem(), /program could not be fetched: the server answered 404/);
  cpSync(join(folder, 'node_modules/edgeshade/dist/wasm'), join(folder, 'alone/wasm'), { recursive: true });
  assert.match(await problem(), /worker that finds edges/);
});

test('no bundler: an import map', { skip }, async () => {
  const [, address] = /src="([^"]+)"/.exec(elementHtml);
  assert.equal(`/${address}`, imports.edgeshade);
  for (const name of Object.keys(pages)) {
    write('plain', name, `/${name}.js`, { head: importMap });
    await showsShadow(`/plain/${name}.html`);
  }
});
