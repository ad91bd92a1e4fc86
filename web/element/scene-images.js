// A scene's images: fetched if they are missing, and decoded by the browser if they are WebP.

import { WebpDecoder } from './webp.js';

/** Decodes WebP bytes into the reader's buffer. Throws an Error if the reader refuses the
 * pixels; returns why the browser can't decode them, or ''. */
async function decodeWebp(reader, decoder, image) {
  const webp = reader.webpOf(image).slice(); // a copy, independent of the program's memory
  if (webp.length === 0) return '';
  let pixels;
  try {
    pixels = await decoder.pixelsOf(webp);
  } catch {
    return 'this browser can\'t decode its WebP data.';
  }
  const problem = reader.roomFor(image, pixels.width, pixels.height);
  if (problem) throw new Error(problem);
  reader.room().set(pixels.rgba);
  return '';
}

/**
 * Has `reader`, a SceneReader, decide on all images. `fetchFile` gets a uri and stores its file
 * where the reader finds it; it throws the reason if it can't.
 */
export async function takeImages(reader, fetchFile) {
  const decoder = new WebpDecoder();
  for (;;) {
    const wanted = JSON.parse(reader.wantedImages());
    if (wanted.length === 0) return;
    const problems = await Promise.all(wanted.map(({ uri }) =>
      fetchFile(uri).then(() => '', (error) => error.message)));
    for (const [i, { image }] of wanted.entries()) {
      const problem = reader.decideImage(image,
        problems[i] || await decodeWebp(reader, decoder, image));
      if (problem) throw new Error(problem);
    }
  }
}
