// Targets of other sizes and cameras other than the page's in three.js: each has its own shadows,
// judged by rays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useBrowser } from './support/browser.mjs';
import { blocksOf } from './support/readme.mjs';
import { openThree } from './support/three.mjs';

const shared = useBrowser({ angle: 'gl-egl' });

/** Runs `act(page, given)` in a page with three.js; returns its result and the page's warnings. */
async function inPage(act, given, release) {
  const page = await openThree(shared, release);
  const told = await page.evaluate(([text, value]) => (0, eval)(`(${text})`)(window.page, value), [act.toString(), given]);
  const warnings = page.reports.filter((text) => /shadow/i.test(text));
  await shared.check(page, [/shadow/i]);
  return { told, warnings };
}

function assertRight(told, { least = 1000, dark = 60 } = {}) {
  for (const [name, of] of Object.entries(told)) {
    assert.ok(of.surfaces > least && of.dark > dark, `${name}: ${of.surfaces} pixels of surfaces, ${of.dark} in shadow`);
    assert.ok(of.beyond <= 0.0002 * of.surfaces && of.wrong <= 0.02 * of.surfaces,
      `${name}: ${of.wrong} of ${of.surfaces} pixels are wrong, ${of.beyond} of them beyond outlines`);
  }
}

const [composed] = blocksOf('with post-processing', 'js');

for (const release of ['three-0.152', 'three'])
  test(`a composer of another pixel ratio, by the README's lines, in ${release}`, async () => {
    const { told, warnings } = await inPage(async ({ ExactShadows, rendererOf, court, targetOf, redOfTarget, judged, drawn }, lines) => {
      const { ShaderPass } = await import('three/addons/postprocessing/ShaderPass.js');
      const { CopyShader } = await import('three/addons/shaders/CopyShader.js');
      const renderer = rendererOf({ width: 160, height: 100 });
      const { scene, camera, light } = court();
      renderer.setAnimationLoop = () => {};
      Object.assign(window, { renderer, scene, camera });
      await import(`data:text/javascript,${encodeURIComponent(`${lines}\nObject.assign(window, { shadows, composer });`)}`);
      const { shadows, composer } = window;
      composer.addPass(new ShaderPass(CopyShader));
      await drawn(shadows, scene, camera);
      const told = {};
      for (const ratio of [0.75, 2]) {
        composer.reset(targetOf(160 * ratio, 100 * ratio));
        composer.setPixelRatio(ratio);
        composer.render();
        const { readBuffer, writeBuffer } = composer;
        const shown = composer.passes[1].uniforms.tDiffuse.value === readBuffer.texture ? readBuffer : writeBuffer;
        told[ratio] = judged(redOfTarget(renderer, shown), shown.width, shown.height, scene, camera, light);
        // The same by beginMasks(), with RenderPass.
        const { RenderPass } = await import('three/addons/postprocessing/RenderPass.js');
        const [own] = composer.passes;
        composer.passes[0] = new RenderPass(scene, camera);
        shadows.beginMasks(scene, camera, shown);
        composer.render();
        shadows.endMasks();
        const again = composer.passes[1].uniforms.tDiffuse.value === composer.readBuffer.texture ? composer.readBuffer : composer.writeBuffer;
        told[`${ratio} masks`] = judged(redOfTarget(renderer, again), again.width, again.height, scene, camera, light);
        composer.passes[0] = own;
      }
      return told;
    }, composed, release);
    console.log(release, told);
    assert.deepEqual(warnings, []);
    assertRight(told);
  });
