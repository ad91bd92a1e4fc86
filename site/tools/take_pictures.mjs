// Takes the pictures that stand in for scenes until they are drawn, in a headless Chromium, into pictures/.
// Needs build/site, and `npm ci` in web/.
//
//   node tools/take_pictures.mjs [NAME...]            these scenes: of the gallery, first, quick-start, hours
//   node tools/take_pictures.mjs --pages FOLDER       screenshots of six pages, on a desktop and on a phone

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { parseArgs } from 'node:util';
import { launchChromium } from '../../web/tests/support/chromium.mjs';
import { serve } from '../../web/tests/support/server.mjs';
import gallery from '../data/gallery.mjs';
import { output, repository } from './paths.mjs';

const { values: options, positionals } = parseArgs({ options: { pages: { type: 'string' } }, allowPositionals: true });

const scenes = { first: 'index.html', 'quick-start': 'three.html', hours: 'sun-hours.html',
  ...Object.fromEntries(gallery.map(({ name }) => [name, `gallery/${name}.html`])) };
const shownPages = { home: 'index.html', gallery: 'gallery/index.html', 'gallery-page': 'gallery/house.html', quick: 'three.html',
  measured: 'docs/measured/gpu.html', method: 'docs/method/counting.html' };
const settleMs = 9000; // masks, then lookups and smoothing
const countMs = 100000; // hours of sun

async function openScene(tab, address) {
  await tab.goto(address);
  await tab.waitForSelector('.stage iframe:not([hidden]), .stage edgeshade-viewer:not([hidden])', { state: 'attached' });
  await sleep(settleMs);
  for (const frame of tab.frames()) // hours of sun are counted meanwhile
    await frame.waitForFunction(() => [...document.querySelectorAll('output')].every(({ textContent }) => !/Counting|\d+ of \d+ (sun )?positions/.test(textContent)), null, { timeout: countMs });
  await sleep(settleMs / 3); // the counted picture is drawn
}

async function takeScenes(browser, address) {
  const names = positionals.length ? positionals : Object.keys(scenes);
  const tab = await browser.newPage({ viewport: { width: 690, height: 900 } });
  for (const name of names) {
    if (!scenes[name]) throw new Error(`There is no scene '${name}': ${Object.keys(scenes).join(', ')}.`);
    await openScene(tab, `${address}/${scenes[name]}`);
    await tab.addStyleTag({ content: '.stage { border: 0 !important; border-radius: 0 !important } .top { position: static !important } .stage .state { display: none }' });
    await tab.locator('.stage').first().screenshot({ path: join(repository, `site/pictures/${name}.jpg`), type: 'jpeg', quality: 78, timeout: 90000 });
    console.log(`${name}: ${await tab.locator('.state').first().textContent() || 'drawn'}`);
  }
}

async function takePages(browser, address, folder) {
  mkdirSync(folder, { recursive: true });
  for (const [device, viewport] of Object.entries({ desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 780 } }))
    for (const [index, [name, page]] of Object.entries(shownPages).entries()) {
      const tab = await browser.newPage({ viewport, colorScheme: index % 2 ? 'dark' : 'light' });
      await tab.goto(`${address}/${page}`);
      await sleep(['home', 'gallery-page', 'quick'].includes(name) ? settleMs : 1000);
      await tab.screenshot({ path: join(folder, `${name}-${device}.png`), timeout: 90000 });
      await tab.close();
    }
}

const server = await serve({ '/': `${output}/` });
const browser = await launchChromium();
try {
  if (options.pages) await takePages(browser, server.address, options.pages);
  else await takeScenes(browser, server.address);
} finally {
  await browser.close();
  await server.close();
}
