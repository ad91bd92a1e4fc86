// Parts of pictures, enlarged so that single pixels are visible.

/**
 * Cuts {x, y, width, height, scale} out of what a canvas has just drawn, over `background`; returns
 * the address of a PNG.
 */
export function cutOut(drawn, { x, y, width, height, scale }, background) {
  const canvas = document.createElement('canvas');
  canvas.width = width * scale;
  canvas.height = height * scale;
  const context = canvas.getContext('2d');
  context.fillStyle = background;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingEnabled = false;
  context.drawImage(drawn, x, y, width, height, 0, 0, canvas.width, canvas.height);
  return canvas.toDataURL('image/png');
}
