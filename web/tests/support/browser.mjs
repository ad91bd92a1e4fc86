// One Chromium and one server for all tests of a file, and a new page for each test.

import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { launchChromium } from './chromium.mjs';
import { serve } from './server.mjs';

/** The page with a scene of 36 triangles. */
export const smallPage = '/#model=tests/small.gltf';

/** The element alone, as in /tests/plain.html, with that scene: it starts in a third of the time that the sample takes. */
export const smallElement = '/tests/small.html';

/**
 * Elements without antialiasing, unless their page says otherwise: software rendering is several times as
 * fast, and pictures don't change at rest.
 */
function withoutAntialiasing() {
  const { define } = CustomElementRegistry.prototype;
  CustomElementRegistry.prototype.define = function (name, type, options) {
    const { connectedCallback } = type.prototype;
    type.prototype.connectedCallback = function () {
      if (!this.hasAttribute('antialias')) this.setAttribute('antialias', 'off');
      connectedCallback.call(this);
    };
    define.call(this, name, type, options);
  };
}

/** Chromium itself waits for a canvas to compose the page. */
const ofChromium = /GPU stall due to ReadPixels/;

/** Clocks of the page and of its WebAssembly run this many times as fast, for tests that wait for long rests. */
function hurry(factor) {
  window.haste = factor;
  const { now } = Performance.prototype;
  Performance.prototype.now = function () { return factor * now.call(this); };
  const { setTimeout } = window;
  window.setTimeout = (act, milliseconds = 0, ...given) => setTimeout.call(window, act, milliseconds / factor, ...given);
}

/** A page is used for so many tests: contexts of WebGL that nothing holds any more may stay, and 16 are allowed. */
const mostUses = 5;

/**
 * Call it at the top of a test file; `angle` and `webGpu` as in chromium.mjs, `roots` as in server.mjs. Pages
 * draw with the native program's GL by default, which takes a fifth less time than SwiftShader. Those with
 * WebGPU draw all on SwiftShader. Pages share a cache, and with it a site's storage.
 * `sharesPages`: a page that passed check() is emptied and opened again for a later test that asks for the
 * same, as loading one takes longer than most tests; for tests that leave the page's globals as they are.
 * open(path, options) returns a page that has loaded its scene, without antialiasing by default, whose
 * clock runs `haste` times as fast; check(page) fails if anything was reported to its console.
 */
export function useBrowser({ webGpu = false, angle = webGpu ? 'swiftshader' : 'gl-egl', roots, sharesPages = false } = {}) {
  const shared = {}, idle = new Map(), contexts = new Map(); // by what was asked for
  before(async () => {
    shared.server = await serve(roots);
    shared.browser = await launchChromium({ angle, webGpu, brief: true });
  });
  after(async () => {
    idle.clear();
    await shared.browser?.close();
    await shared.server?.close();
  });

  shared.open = async (path = smallPage, { size = { width: 800, height: 500 }, init, haste = 1, scene = true, antialias = false, ...context } = {}) => {
    const asked = sharesPages && !init ? JSON.stringify([path, size, haste, scene, antialias, context]) : null;
    const kept = idle.get(asked);
    if (kept) {
      idle.delete(asked);
      return kept;
    }
    const options = { viewport: size, ...context }, kind = JSON.stringify(options);
    if (!contexts.has(kind)) contexts.set(kind, await shared.browser.newContext(options));
    const page = await contexts.get(kind).newPage();
    page.setDefaultTimeout(60000);
    Object.assign(page, { reports: [], asked, uses: 0 });
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) page.reports.push(message.text());
    });
    page.on('pageerror', (error) => page.reports.push(String(error)));
    if (!antialias) await page.addInitScript(withoutAntialiasing);
    if (init) await page.addInitScript(init);
    if (haste !== 1) await page.addInitScript(hurry, haste);
    await page.goto(new URL(path, shared.server.address).href);
    if (scene) await loaded(page);
    return page;
  };
  shared.check = async (page, allowed = []) => {
    const reports = page.reports.filter((text) => ![ofChromium, ...allowed].some((pattern) => pattern.test(text)));
    assert.deepEqual(reports, [], 'the console stays empty');
    page.uses += 1;
    if (page.asked && page.uses < mostUses && !idle.has(page.asked)) {
      await page.evaluate(() => { document.body.replaceChildren(); window.gc(); });
      page.reports = [];
      idle.set(page.asked, page);
      return;
    }
    await page.close();
  };
  return shared;
}

/** Waits until a scene is shown and nothing is loading. */
export async function loaded(page) {
  await page.waitForFunction(() => {
    const viewer = document.querySelector('edgeshade-viewer');
    return viewer?.loaded && !viewer.hasAttribute('aria-busy');
  });
  await settled(page);
}

/** Waits until requested frames have been drawn. */
export const settled = (page) => page.evaluate(() => new Promise((resolve) =>
  requestAnimationFrame(() => requestAnimationFrame(() => resolve()))));

export const stateOf = (page) =>
  page.evaluate(() => document.querySelector('edgeshade-viewer').state);

/** The sentences that the element shows. */
export const noticesOf = (page, kind) => page.evaluate((wanted) =>
  [...document.querySelector('edgeshade-viewer').shadowRoot.querySelectorAll('.notice')]
    .filter((notice) => !wanted || notice.dataset.kind === wanted)
    .map((notice) => notice.dataset.sentence), kind);

/** Waits for a sentence that matches. */
export async function waitForNotice(page, pattern) {
  await page.waitForFunction(([source, flagsOf]) =>
    [...document.querySelector('edgeshade-viewer').shadowRoot.querySelectorAll('.notice')]
      .some((notice) => new RegExp(source, flagsOf).test(notice.dataset.sentence)),
  [pattern.source, pattern.flags]);
}

/** Drops files onto the page: [{name, bytes}]; `at`: the element that receives them. */
export async function drop(page, files, at = '#viewer') {
  const transfer = await page.evaluateHandle((list) => {
    const data = new DataTransfer();
    for (const { name, base64 } of list) {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      data.items.add(new File([bytes], name));
    }
    return data;
  }, files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString('base64') })));
  for (const type of ['dragenter', 'dragover', 'drop'])
    await page.dispatchEvent(at, type, { dataTransfer: transfer });
}
