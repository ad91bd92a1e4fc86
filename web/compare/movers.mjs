// Frame times of three.js while a skinned figure walks through the sample, beside those without it,
// when all rests: with a lookup, and with masks alone. One run of Chromium. Prints JSON. Needs
// build/web and `npm ci`.
//
//   node compare/movers.mjs [--size 640x360] [--frames 15] [--angle swiftshader|gl-egl]

import { measureInThree } from './three-tab.mjs';

/** In the page: milliseconds of the fastest frame of each kind, by light, with a moving camera. */
async function measured({ wide, frames }) {
  const { three, ExactShadows, rendererOf, loaded, walkingFigure, cameraOf, lampOf, drawn } = window.page;
  const renderer = rendererOf(wide);
  const gl = renderer.getContext();
  const camera = cameraOf({ from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 }, wide.width / wide.height);
  const pixel = new Uint8Array(4);
  const results = [];
  for (const lamp of [{ kind: 'DirectionalLight', position: [-6.2, 6.2, -3] }, { kind: 'PointLight', position: [1.5, 2.2, 2] }]) {
    const scene = new three.Scene();
    const { figure, pose } = await walkingFigure();
    scene.add(await loaded('/assets/pavilion.glb'), figure, ...lampOf(lamp));
    let step = 0;
    const walk = () => {
      step += 1;
      pose(0.11 * step);
      figure.position.set(-2.4 + 0.21 * (step % 20), 0.47, 1.1 + 0.13 * (step % 20));
    };
    walk();
    const now = (draw) => {
      const since = performance.now();
      draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return performance.now() - since;
    };
    const of = { light: lamp.kind };
    for (const lookups of [1, 0]) {
      const shadows = new ExactShadows(renderer, { lookups }).add(scene);
      const draw = () => shadows.render(scene, camera);
      await drawn(shadows, scene, camera);
      for (const since = performance.now(); lookups && shadows.lights[0].method !== 'lookup and movers';) {
        if (performance.now() - since > 90000) throw new Error(`${shadows.lights[0].method}: ${shadows.lights[0].reason}`);
        await new Promise((resolve) => { setTimeout(resolve, 200); });
        walk();
        draw();
      }
      const rest = [], walking = [];
      for (let i = 0; i < frames; ++i) { // in turns: without the figure, everything rests
        camera.position.x = -2.6 + 0.01 * i;
        camera.updateMatrixWorld();
        figure.visible = false;
        draw();
        rest.push(now(draw));
        figure.visible = true;
        walk();
        draw();
        walk();
        walking.push(now(draw));
        if (lookups && shadows.cost.lookedUp !== 1) throw new Error('The lookup ended.');
      }
      of[lookups ? 'restMs' : 'restMaskedMs'] = Math.min(...rest);
      of[lookups ? 'walkingMs' : 'walkingMaskedMs'] = Math.min(...walking);
      shadows.dispose();
    }
    of.ratio = of.walkingMs / of.restMs;
    results.push(of);
  }
  return { renderer: window.page.rendererName(), size: wide, frames, results };
}

await measureInThree(measured);
