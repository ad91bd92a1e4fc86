// The types in edgeshade-viewer.d.ts: they compile in a page's strict use of them, and they match
// the values that the element really returns.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { repository } from './support/server.mjs';

const web = join(repository, 'web');
const compiler = join(web, 'node_modules/typescript/bin/tsc');

/** tsc's messages about a file, "" if there are none. */
function complaints(file) {
  const folder = mkdtempSync(join(web, 'node_modules/.types-'));
  try {
    const settings = join(folder, 'tsconfig.json');
    writeFileSync(settings, JSON.stringify({
      compilerOptions: { strict: true, noEmit: true, module: 'esnext', moduleResolution: 'bundler',
        target: 'es2022', lib: ['es2022', 'dom', 'dom.iterable'], types: [],
        paths: { edgeshade: [join(web, 'element/edgeshade-viewer.d.ts')] } },
      files: [file],
    }));
    const { stdout, stderr, status } = spawnSync(process.execPath, [compiler, '-p', settings], { encoding: 'utf8' });
    assert.ok(status !== null, 'tsc ran');
    return stdout + stderr;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a page written in strict TypeScript compiles', () => {
  assert.equal(complaints(join(web, 'tests/types/use.ts')), '');
});

const shared = useBrowser();

test('state, statistics and what load tells have the types that are promised', async () => {
  const page = await shared.open();
  const told = await page.evaluate(async () => {
    const viewer = document.querySelector('edgeshade-viewer');
    const detail = await viewer.load('tests/small.gltf');
    return { state: viewer.state, stats: viewer.stats, detail };
  });
  await shared.check(page);
  const folder = mkdtempSync(join(web, 'node_modules/.types-'));
  try {
    const file = join(folder, 'told.ts');
    const text = (value) => JSON.stringify(value, null, 2);
    writeFileSync(file, `import type { LoadDetail, Stats, ViewState } from 'edgeshade';
export const state: ViewState = ${text(told.state)};
export const stats: Stats = ${text(told.stats)};
export const detail: LoadDetail = ${text(told.detail)};
`);
    assert.equal(complaints(file), '', readFileSync(file, 'utf8'));
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('every command of the types is one that the program knows', async () => {
  const types = readFileSync(join(web, 'element/edgeshade-viewer.d.ts'), 'utf8');
  const commands = [.../export type Command =([^;]*);/.exec(types)[1].matchAll(/'(\w+)'/g)].map(([, name]) => name);
  assert.ok(commands.length > 20, `${commands.length} commands`);
  const page = await shared.open();
  const refused = await page.evaluate((names) => names.filter((name) => {
    try {
      document.querySelector('edgeshade-viewer').run(name);
      return false;
    } catch {
      return true;
    }
  }), commands);
  assert.deepEqual(refused, []);
  await shared.check(page);
});
