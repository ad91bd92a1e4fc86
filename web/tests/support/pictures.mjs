// Decodes and compares pictures in the browser.

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

/** Returns {pixels, different, astray, colors}. different: pixels that differ by more than 2 in a
 * channel; astray: those that differ by more than 12 where the second picture has no step of that
 * size within a pixel; colors: number of the first picture's colours. */
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
    const step = (p, i, q, j) => Math.max(Math.abs(p[i] - q[j]), Math.abs(p[i + 1] - q[j + 1]), Math.abs(p[i + 2] - q[j + 2]), Math.abs(p[i + 3] - q[j + 3]));
    const atOutline = (x, y) => {
      for (let v = Math.max(0, y - 1); v <= Math.min(b.height - 1, y + 1); ++v)
        for (let u = Math.max(0, x - 1); u <= Math.min(b.width - 1, x + 1); ++u)
          if (step(b.data, 4 * (v * b.width + u), b.data, 4 * (y * b.width + x)) > 12) return true;
      return false;
    };
    let different = 0, astray = 0;
    const colors = new Set();
    for (let y = 0, i = 0; y < a.height; ++y)
      for (let x = 0; x < a.width; ++x, i += 4) {
        colors.add((a.data[i] << 16) | (a.data[i + 1] << 8) | a.data[i + 2]);
        const apart = step(a.data, i, b.data, i);
        if (apart > 2) different += 1;
        if (apart > 12 && !atOutline(x, y)) astray += 1;
      }
    return { pixels: a.width * a.height, different, astray, colors: colors.size };
  }, [first, second].map((png) => png.toString('base64')));
}
