// Parts of pictures, enlarged so that their pixels can be told apart.

/** {x, y, width, height, scale} of a bitmap as the address of a PNG. */
export function cutOut(bitmap, { x, y, width, height, scale }) {
  const canvas = document.createElement('canvas');
  canvas.width = width * scale;
  canvas.height = height * scale;
  const context = canvas.getContext('2d');
  context.imageSmoothingEnabled = false;
  context.drawImage(bitmap, x, y, width, height, 0, 0, canvas.width, canvas.height);
  return canvas.toDataURL('image/png');
}
