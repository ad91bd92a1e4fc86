// A page with three.js and its exact shadows, and masks by the native program of the same view.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { isLong } from './long.mjs';
import { program } from './native.mjs';

const all = ['three-0.152', 'three-0.169', 'three'];

/** The release that all tests take, from EDGESHADE_THREE; undefined: each its own. */
const only = process.env.EDGESHADE_THREE;
if (only && !all.includes(only)) throw new Error(`EDGESHADE_THREE is '${only}', which is not one of ${all.join(', ')}.`);

/** The release to test in place of one, as a name of a package. */
export const inPlaceOf = (release) => only ?? release;

/**
 * The releases to test of a list, oldest first, as names of packages: the earlier ones lack a feature. Only the newest,
 * except under ./test --long, which also runs all tests with each release.
 */
export const releasesOf = (...list) => (only ? (all.indexOf(only) < all.indexOf(list[0]) ? [] : [only]) : isLong ? list : list.slice(-1));

/** Every release, for tests of what they do in different ways. */
export const releases = only ? [only] : all;

export const size = { width: 480, height: 270 };

/** Opens the page with `release` of three.js, or the one that all tests take. */
export async function openThree(shared, release = 'three', options = {}) {
  const page = await shared.open(`/tests/three.html?three=${inPlaceOf(release)}`, { scene: false, ...options });
  await page.waitForFunction(() => window.page);
  return page;
}

/**
 * Runs `act(page, given)` in a page with three.js that draws with the native program's GL; returns
 * its result, and the page. `options` as in openThree(). Skips the test with another GL.
 */
export async function inNativeGl(shared, context, act, given = {}, release = undefined, options = {}) {
  const page = await openThree(shared, release, options);
  const name = await page.evaluate(() => window.page.rendererName());
  if (!/llvmpipe/.test(name)) {
    context.skip(`Chromium draws with ${name} here`);
    await page.close();
    return {};
  }
  const told = await page.evaluate(({ text, of }) => (0, eval)(`(${text})`)(window.page, of), { text: act.toString(), of: given });
  return { page, told };
}

/**
 * Runs `act(page, foliage, given)` in a page with three.js, with foliage.js, tint-rays.js and soft-rays.js, whose
 * clock is hasty; returns its result, and the page's reports, of which `allowed` patterns are expected.
 */
export async function inFoliage(shared, act, { release, allowed, given } = {}) {
  const page = await openThree(shared, release, { haste: 5 });
  const told = await page.evaluate(async ([text, value]) => {
    const foliage = { ...await import('/tests/foliage.js'), ...await import('/tests/tint-rays.js'), ...await import('/tests/texel-alpha.js'), ...await import('/tests/soft-rays.js') };
    return (0, eval)(`(${text})`)(window.page, foliage, value);
  }, [act.toString(), given]);
  const { reports } = page;
  await shared.check(page, allowed);
  return { told, reports };
}

/** The result of `render --mask` for a .glb's bytes or path, as colour PNG bytes. */
export function nativeMask(scene, { from, to, fov, height }, light) {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  try {
    const png = join(folder, 'mask.png');
    let file = scene;
    if (typeof scene !== 'string') {
      file = join(folder, 'scene.glb');
      writeFileSync(file, scene);
    }
    execFileSync(program, ['render', file, png, '--mask', '--size', `${size.width}x${size.height}`,
      '--camera-from', `${from}`, '--camera-to', `${to}`, '--fov', `${fov}`, ...(height ? ['--ortho', `${height}`] : []), ...light],
    { stdio: 'pipe', timeout: 60000 });
    return readFileSync(png);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/**
 * Compares two masks pixel by pixel: the page's as `red` (redTextOf), the native one as PNG. Returns
 * {surfaces, wrong, beyond}. surfaces: pixels that show something; wrong: those where only one mask
 * is lit; beyond: wrong ones with no boundary of the native mask or of visible geometry within a
 * pixel.
 */
export function compareMasks(page, red, png) {
  return page.evaluate(async ({ text, base64 }) => {
    const bytesOf = (of) => Uint8Array.from(atob(of), (character) => character.charCodeAt(0));
    const values = bytesOf(text), bytes = bytesOf(base64);
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { premultiplyAlpha: 'none' });
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    // 0: no surface; 1: in shadow; 2: lit.
    const known = (x, y) => (data[4 * (y * width + x) + 3] === 0 ? 0 : data[4 * (y * width + x)] > 127 ? 2 : 1);
    let surfaces = 0, wrong = 0, beyond = 0, dark = 0;
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x) {
        const here = known(x, y);
        if (here === 0) continue;
        surfaces += 1;
        dark += here === 1;
        if ((values[y * width + x] > 127) === (here === 2)) continue;
        wrong += 1;
        let boundary = false;
        for (let v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); ++v)
          for (let u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); ++u) boundary ||= known(u, v) !== here;
        beyond += !boundary;
      }
    return { surfaces, dark, wrong, beyond };
  }, { text: red, base64: png.toString('base64') });
}
