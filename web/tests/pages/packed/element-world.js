// Globals that the README's lines for the element need: files, and a label.

const bytes = await (await fetch('/house.glb')).arrayBuffer();

/**
 * Red of two points of the small scene's ground, seen from above under the sun of the README's tag:
 * one in shadow, one in light.
 */
async function shadowAndLightOf(viewer) {
  viewer.change({ lights: [[0.4, 1, 0.3, 0]], left: { shadows: 'auto' }, ambient: 0,
    camera: { from: [0, 10, 0.01], to: [0, 0.2, 0], fov: 60 } });
  const picture = await createImageBitmap(await viewer.screenshot());
  const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d', { willReadFrequently: true });
  context.drawImage(picture, 0, 0);
  const perUnit = picture.height / 2 / Math.tan(Math.PI / 6) / 9.8;
  return [[-0.8, -0.6], [2, -2]].map(([x, z]) =>
    context.getImageData(picture.width / 2 + perUnit * x, picture.height / 2 + perUnit * z, 1, 1).data[0]);
}

Object.assign(window, { files: [new File([bytes], 'house.glb')], label: document.createElement('p'), shadowAndLightOf });
