// The built site: its links, and in Chromium its first screen, live code, search, sorting and accessibility. It
// is served from a sub-folder, as projects' pages are.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launchChromium } from '../../web/tests/support/chromium.mjs';
import { serve } from '../../web/tests/support/server.mjs';
import { brokenLinks } from '../tools/check_links.mjs';
import { claims, measuredDocuments } from '../tools/measurements.mjs';
import { output } from '../tools/paths.mjs';
import { sectionsOf } from '../tools/search-data.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const folder = '/some/folder/';
const small = { width: 480, height: 420 }; // software draws few pixels quickly
let server, browser;

before(async () => {
  server = await serve({ [folder]: `${output}/` });
  browser = await launchChromium({ angle: 'gl-egl' });
});
after(async () => {
  await browser?.close();
  await server?.close();
});

/** A page of the site; close(tab) fails if its console has errors or it has asked another server. */
async function open(page, options = {}) {
  const tab = await browser.newPage({ viewport: small, ...options });
  tab.setDefaultTimeout(60000);
  tab.reports = [];
  tab.on('console', (message) => { if (message.type() === 'error') tab.reports.push(message.text()); });
  tab.on('pageerror', (error) => tab.reports.push(String(error)));
  tab.on('request', (request) => {
    if (!/^(data|blob|about):/.test(request.url()) && !request.url().startsWith(server.address + folder)) tab.reports.push(`asks ${request.url()}`);
  });
  await tab.goto(server.address + folder + page);
  return tab;
}
async function close(tab) {
  assert.deepEqual(tab.reports, []);
  await tab.close();
}

/** Waits until the live scene is drawn. */
const drawn = (tab) => tab.waitForFunction(() => {
  const stage = document.querySelector('.live .stage');
  return !stage.querySelector('iframe').hidden && stage.querySelector('.state').textContent === '';
});

test('every link leads somewhere on the site', () => {
  assert.deepEqual(brokenLinks(output), []);
});

test('each figure of README.md has commands that reproduce it', () => {
  const measured = new Map(measuredDocuments().map(({ document, commands }) => [document, commands]));
  const rows = claims();
  assert.ok(rows.length > 3, `${rows.length} figures`);
  for (const { claim, documents } of rows)
    assert.ok(documents.some((document) => measured.get(document)?.length), `${claim} links to ${documents}, which no script writes.`);
});

test('the check of links notices a missing page, a missing part, another server and an absolute path', () => {
  const made = mkdtempSync(join(tmpdir(), 'site-'));
  try {
    mkdirSync(join(made, 'client'));
    writeFileSync(join(made, 'a.html'), '<a href="b.html"></a><a href="a.html#no"></a><img src="https://x.org/p.png"><a href="/a.html"></a><a href="https://x.org">ok</a><p id="yes"></p><a href="#yes"></a>');
    writeFileSync(join(made, 'client/c.js'), "import './none.js';");
    const faults = brokenLinks(made).join('\n');
    for (const part of ['b.html', 'a.html#no', 'x.org/p.png', 'sub-folder', 'none.js']) assert.ok(faults.includes(part), `${part}: ${faults}`);
    assert.equal(faults.split('\n').filter((fault) => fault.includes('#yes') || fault.includes('x.org ')).length, 0);
  } finally {
    rmSync(made, { recursive: true });
  }
});

test('sections of a page are its parts below headings, as text', () => {
  const html = '<title>t</title><main id="content"><h1>A &amp; B</h1><p>one</p><h2 id="c">C</h2><pre>x &lt; y</pre><script>no</script></main>';
  assert.deepEqual(sectionsOf('p.html', html), [
    { title: 'A & B', section: '', page: 'p.html', text: 'A & B one' },
    { title: 'A & B', section: 'C', page: 'p.html#c', text: 'x < y' }]);
});

test('the first screen shows the element, and its sun moves', async () => {
  const tab = await open('index.html', { reducedMotion: 'reduce' }); // otherwise it scrolls for a while
  await tab.waitForFunction(() => document.querySelector('#first').loaded && !document.querySelector('.stage img'));
  const sun = () => tab.evaluate(() => document.querySelector('#first').state.lights[0].slice(0, 3));
  const before = await sun();
  await tab.focus('#elevation');
  await tab.keyboard.press('ArrowRight');
  const higher = await sun();
  assert.ok(higher[1] > before[1], `${before} to ${higher}`);
  await tab.locator('#dial').scrollIntoViewIfNeeded();
  const dial = await tab.locator('#dial').boundingBox();
  await tab.mouse.move(dial.x + dial.width / 2, dial.y + dial.height / 2);
  await tab.mouse.down();
  await tab.mouse.move(dial.x + 0.75 * dial.width, dial.y + dial.height / 2); // east, at half height
  await tab.mouse.up();
  const [x, y, z] = await sun();
  assert.ok(x > 0.5 && y > 0.5 && Math.abs(z) < 0.05, `${[x, y, z]}`);
  await close(tab);
});

test('a page of the gallery draws its scene, says what is wrong with edited code, and starts again', async () => {
  const tab = await open('gallery/room.html');
  await drawn(tab);
  await tab.click('.edit');
  await tab.fill('.live textarea', "throw new Error('This is wrong.');");
  await tab.click('.run');
  await tab.waitForFunction(() => /This is wrong/.test(document.querySelector('.live .state').textContent));
  tab.reports.splice(0); // the error is in the console, too
  await tab.click('.reset');
  await drawn(tab);
  assert.match(await tab.inputValue('.live textarea'), /A room in the morning/);
  await close(tab);
});

test('the quick start draws shadows', async () => {
  const tab = await open('three.html');
  await drawn(tab);
  const frame = tab.frames().find((each) => each.parentFrame());
  await frame.evaluate(() => new Promise((resolve) => { setTimeout(resolve, 1500); }));
  const stage = tab.locator('.live .stage');
  const shadowed = await stage.screenshot();
  await tab.evaluate(() => {
    const code = document.querySelector('.live textarea');
    code.value = code.value.replace('sun.castShadow = true;', '');
  });
  await tab.click('.run');
  await drawn(tab);
  await frame.waitForTimeout(1500);
  assert.notDeepEqual(await stage.screenshot(), shadowed, 'without castShadow the picture is another');
  await close(tab);
});

test('the benchmark draws its room', async () => {
  const tab = await open('app/compare/index.html?model=room&antialias=off');
  await tab.waitForFunction(() => /room/.test(document.querySelector('#scene-name').textContent) && window.comparison);
  await close(tab);
});

test('search finds a section, and its link leads there', async () => {
  const tab = await open('docs/limits.html');
  await tab.keyboard.press('/');
  await tab.fill('#search-words', 'transparentCast');
  await tab.waitForSelector('#search-found a');
  await tab.keyboard.press('Enter');
  await tab.waitForURL(/(web\/index|exact-shadows)\.html/);
  await close(tab);
});

test('columns of measured tables are sorted by number', async () => {
  const tab = await open('docs/measured/accuracy.html');
  const column = () => tab.$$eval('table:first-of-type tbody tr', (rows) => rows.slice(0, 10).map((row) => row.cells[1].textContent));
  await tab.locator('th').nth(1).locator('button').click();
  const numbers = (await column()).map((text) => Number(text.replaceAll(',', '')));
  assert.deepEqual(numbers, [...numbers].sort((a, b) => a - b));
  await tab.locator('th').nth(1).locator('button').click();
  assert.deepEqual((await column()).map((text) => Number(text.replaceAll(',', ''))), numbers.reverse());
  await close(tab);
});

test('axe finds nothing on these pages, light and dark', async () => {
  for (const [page, colorScheme] of [['index.html', 'light'], ['gallery/house.html', 'dark'], ['docs/measured/gpu.html', 'dark'],
    ['sun-hours.html', 'light'], ['api/js/three/exact-shadows.html', 'light']]) {
    const tab = await open(page, { colorScheme });
    await tab.evaluate(axe);
    const { violations } = await tab.evaluate(() => window.axe.run(document, { iframes: false }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${page}, ${id}: ${nodes.slice(0, 2).map(({ html }) => html).join(' ')}`), []);
    await tab.close();
  }
});
