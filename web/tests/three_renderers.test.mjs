// One scene of three.js drawn by several renderers, with exact shadows and without.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser({ sharesPages: true });

/** Runs act(tools) in a page with a yard; returns its result, and the page's reports, of which `allowed` patterns are expected. */
async function inPage(act, allowed) {
  const page = await openThree(shared, 'three', { haste: 5 });
  const told = await page.evaluate((text) => {
    const { yard, whiten, cameraOf, comparedWithRays, redOf, rendererOf } = window.page;
    const size = { width: 200, height: 130 }, world = yard(size), { scene, light } = world;
    whiten(scene);
    const camera = cameraOf({ from: [5, 4, 6], to: [0, 0.6, 0], fov: 50 }, size.width / size.height);
    const judge = (renderer) => comparedWithRays(redOf(renderer), renderer, scene, camera, light);
    return (0, eval)(`(${text})`)({ ...window.page, ...world, camera, judge, another: () => rendererOf(size) });
  }, act.toString());
  const { reports } = page;
  await shared.check(page, allowed);
  return { told, reports };
}

const isRight = ({ dark, wrong, beyond }, name) => assert.ok(dark > 200 && wrong <= 20 && beyond === 0, `${name}: ${dark} dark pixels, ${wrong} wrong, ${beyond} beyond outlines`);

test('two renderers have shadows of their own, and one keeps them when the other is done', async () => {
  const { told } = await inPage(async ({ ExactShadows, renderer, another, scene, camera, box, drawn, rested, judge }) => {
    const other = another(), first = new ExactShadows(renderer).add(scene), second = new ExactShadows(other).add(scene);
    const results = {};
    await drawn(first, scene, camera);
    await drawn(second, scene, camera);
    first.render(scene, camera);
    Object.assign(results, { first: judge(renderer), second: judge(other) });
    await rested(first, scene, camera);
    await rested(second, scene, camera);
    first.render(scene, camera);
    Object.assign(results, { 'first, looked up': judge(renderer), 'second, looked up': judge(other) });
    first.dispose();
    box.position.x += 0.4;
    await drawn(second, scene, camera);
    results['second alone'] = judge(other);
    second.dispose();
    for (const name of ['onBeforeCompile', 'customProgramCacheKey', 'onBeforeRender']) if (Object.hasOwn(box.material, name)) throw new Error(`${name} stays`);
    const again = new ExactShadows(renderer).add(scene);
    await drawn(again, scene, camera);
    results.again = judge(renderer);
    again.dispose();
    return results;
  });
  for (const [name, of] of Object.entries(told)) isRight(of, name);
});

test('another renderer draws with its own shadows, as if there were none of the first', async () => {
  const { told } = await inPage(async ({ ExactShadows, renderer, another, scene, camera, light, drawn, redOf, judge }) => {
    const other = another();
    other.shadowMap.enabled = true;
    light.shadow.mapSize.set(256, 256);
    const before = (other.render(scene, camera), redOf(other));
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, camera);
    const beside = (other.render(scene, camera), redOf(other));
    shadows.render(scene, camera);
    const exact = judge(renderer);
    shadows.dispose();
    return { dark: before.filter((red) => red < 128).length, differ: before.filter((red, i) => red !== beside[i]).length, exact };
  });
  assert.equal(told.differ, 0);
  assert.ok(told.dark > 200);
  isRight(told.exact, 'exact');
});

test('two ExactShadows of one renderer: a sentence says so, and the first one\'s shadows stay', async () => {
  const { told, reports } = await inPage(async ({ ExactShadows, renderer, scene, camera, drawn, judge }) => {
    const first = new ExactShadows(renderer).add(scene);
    await drawn(first, scene, camera);
    const second = new ExactShadows(renderer).add(scene);
    await drawn(second, scene, camera);
    first.render(scene, camera);
    const both = judge(renderer);
    first.dispose();
    await drawn(second, scene, camera);
    const later = judge(renderer);
    second.dispose();
    return { both, later, error: renderer.getContext().getError() };
  }, [/other ExactShadows/]);
  assert.equal(told.error, 0);
  isRight(told.both, 'both');
  isRight(told.later, 'the second, once the first is disposed of');
  assert.deepEqual(reports, ["Material 'MeshToonMaterial' has the shadows of other ExactShadows of its renderer: dispose() of those first."]);
});

test('a material whose onBeforeCompile is set later has both, and keeps its own afterwards', async () => {
  const { told } = await inPage(async ({ ExactShadows, renderer, scene, camera, ground, drawn, judge, redAt }) => {
    const shadows = new ExactShadows(renderer).add(scene);
    await drawn(shadows, scene, camera);
    const { material } = ground, { customProgramCacheKey } = material;
    const halve = (shader) => { shader.fragmentShader = shader.fragmentShader.replace('#include <dithering_fragment>', (found) => `${found}\n\tgl_FragColor.rgb *= 0.75;`); };
    const lit = [2.5, 0, 2.5], before = redAt(renderer, camera, lit);
    material.onBeforeCompile = halve;
    material.needsUpdate = true;
    await drawn(shadows, scene, camera);
    const after = redAt(renderer, camera, lit), exact = judge(renderer);
    shadows.dispose();
    return { before, after, exact, restored: [material.onBeforeCompile === halve, Object.hasOwn(material, 'customProgramCacheKey'), customProgramCacheKey !== material.customProgramCacheKey] };
  });
  assert.deepEqual([told.before, told.after], [255, 191]);
  isRight(told.exact, 'both');
  assert.deepEqual(told.restored, [true, false, true]);
});
