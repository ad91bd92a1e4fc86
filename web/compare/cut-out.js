// Parts of pictures, enlarged so that their pixels can be told apart.

/** {x, y, width, height, scale} of what a canvas has just drawn, before `background`, as the address of a PNG. */
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
