// Pictures, decoded and compared in the browser.

/** The viewer's picture as PNG bytes. */
export async function picture(page) {
  const base64 = await page.evaluate(async () => {
    const blob = await document.querySelector('edgeshade-viewer').screenshot();
    const bytes = new Uint8Array(await blob.arrayBuffer());
    let text = '';
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(text);
  });
  return Buffer.from(base64, 'base64');
}

/** {pixels, different, colors}: pixels that differ by more than 2 in a channel, and how many colours
 * the first picture has. */
export function compare(page, first, second) {
  return page.evaluate(async (pngs) => {
    const [a, b] = await Promise.all(pngs.map(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }),
        { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height);
    }));
    if (a.width !== b.width || a.height !== b.height)
      throw new Error(`${a.width}x${a.height} is not ${b.width}x${b.height}`);
    let different = 0;
    const colors = new Set();
    for (let i = 0; i < a.data.length; i += 4) {
      colors.add((a.data[i] << 16) | (a.data[i + 1] << 8) | a.data[i + 2]);
      for (let c = 0; c < 4; ++c)
        if (Math.abs(a.data[i + c] - b.data[i + c]) > 2) {
          different += 1;
          break;
        }
    }
    return { pixels: a.width * a.height, different, colors: colors.size };
  }, [first, second].map((png) => png.toString('base64')));
}
