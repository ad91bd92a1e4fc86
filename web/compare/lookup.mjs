// Frame times of three.js with a resting light, in one run of Chromium: with a lookup, with masks,
// and with three.js's own map, which it keeps, on the sample with its own materials. Prints JSON.
// Needs build/web and `npm ci`.
//
//   node compare/lookup.mjs [--size 640x360] [--frames 15] [--angle swiftshader|gl-egl]

import { measureInThree } from './three-tab.mjs';

/**
 * In the page: milliseconds of each frame by each method, in turn, with a moving camera; also the
 * cost of building the map.
 */
async function measured({ wide, frames }) {
  const { three, ExactShadows, rendererOf, loaded, cameraOf, lampOf, rested } = window.page;
  const renderer = rendererOf(wide);
  const gl = renderer.getContext();
  const camera = cameraOf({ from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 }, wide.width / wide.height);
  const pixel = new Uint8Array(4);
  const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
  const results = [];
  for (const lamp of [{ kind: 'DirectionalLight', position: [-6.2, 6.2, -3] }, { kind: 'PointLight', position: [1.5, 2.2, 2] }]) {
    const scene = new three.Scene();
    const [light, ...target] = lampOf(lamp);
    scene.add(await loaded('/assets/pavilion.glb'), light, ...target);
    light.shadow.mapSize.set(2048, 2048);
    if (light.isDirectionalLight) Object.assign(light.shadow.camera, { left: -8, right: 8, top: 8, bottom: -8 });
    const timed = (draw) => {
      const times = [];
      for (let i = 0; i < frames + 2; ++i) {
        camera.position.x = -2.6 + 0.01 * i;
        camera.updateMatrixWorld();
        const since = performance.now();
        draw();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        if (i > 1) times.push(performance.now() - since);
      }
      return median(times);
    };
    const of = { light: lamp.kind };
    of.none = timed(() => renderer.render(scene, camera));
    Object.assign(renderer.shadowMap, { enabled: true, autoUpdate: false, needsUpdate: true });
    scene.traverse(({ material }) => { if (material) material.needsUpdate = true; });
    of.keptMap = timed(() => renderer.render(scene, camera));
    renderer.shadowMap.enabled = false;
    scene.traverse(({ material }) => { if (material) material.needsUpdate = true; });
    for (const [name, lookups] of [['masked', 0], ['lookedUp', 1]]) {
      const shadows = new ExactShadows(renderer, { lookups }).add(scene);
      const since = performance.now();
      await rested(shadows, scene, camera, lookups);
      of[`${name}Ready`] = performance.now() - since;
      of[name] = timed(() => shadows.render(scene, camera));
      of[`${name}Bytes`] = shadows.cost.bytes;
      if (lookups && shadows.cost.lookedUp !== 1) of.why = [...shadows.notLookedUp.values()].join();
      shadows.dispose();
    }
    results.push(of);
  }
  return { renderer: window.page.rendererName(), size: wide, frames, results };
}

await measureInThree(measured);
