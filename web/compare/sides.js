// The two ways of drawing, each behind the same two calls: frame(changes, started) draws one frame
// after these changes of the view, calls started() as it begins, or later with when that was, and
// resolves when it is finished; picture() gives the pixels.

import { finish } from './timing.js';

/** edgeshade's element. It draws in the browser's next frame, and tells when it has. */
export function viewerSide(viewer) {
  const canvas = viewer.shadowRoot.querySelector('canvas');
  const context = canvas.getContext('webgl');
  return {
    canvas,
    context,
    frame: (changes, started) => new Promise((resolve) => {
      viewer.addEventListener('frame', () => {
        started(document.timeline.currentTime); // when the browser's frame began that it drew in
        finish(context);
        resolve();
      }, { once: true });
      viewer.change(changes);
    }),
    picture: async () => createImageBitmap(await viewer.screenshot()),
  };
}

/** three.js's scene, with the view that edgeshade's element has. */
export function cubeMapSide(canvas, scene, viewer) {
  return {
    canvas,
    context: scene.context,
    frame: (changes, started) => new Promise((resolve) => {
      requestAnimationFrame(() => {
        started();
        scene.follow({ ...viewer.state, ...changes });
        scene.draw();
        finish(scene.context);
        resolve();
      });
    }),
    picture: async () => {
      scene.follow(viewer.state);
      scene.draw();
      return createImageBitmap(canvas); // in the task that drew it
    },
  };
}
