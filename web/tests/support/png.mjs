// Writes and reads PNG.

import { deflateSync, inflateSync } from 'node:zlib';

/** PNG's checksum. */
function crc32(bytes) {
  let sum = -1;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = (sum >>> 1) ^ (sum & 1 ? 0xEDB88320 : 0);
  }
  return ~sum >>> 0;
}

function chunk(type, content) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), content]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(content.length);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}

/** `texels`: RGBA, 8 bits each, rows from the top. */
export function pngOf(texels, width, height) {
  const header = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 6, 0, 0, 0]);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  const rows = Array.from({ length: height }, (_, y) =>
    Buffer.concat([Buffer.of(0), texels.subarray(4 * width * y, 4 * width * (y + 1))]));
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header),
    chunk('IDAT', deflateSync(Buffer.concat(rows))), chunk('IEND', Buffer.alloc(0))]);
}

/** Reads a PNG of 16-bit grey and alpha, written by the program in one chunk and without
 * filters: {width, values(pixel, channel)}. */
export function greyAlphaOf(png) {
  const width = png.readUInt32BE(16);
  const start = png.indexOf('IDAT') + 4;
  const rows = inflateSync(png.subarray(start, start + png.readUInt32BE(start - 8)));
  const place = (pixel) => Math.floor(pixel / width) * (1 + 4 * width) + 1 + 4 * (pixel % width);
  return { width, values: (pixel, channel) => rows.readUInt16BE(place(pixel) + 2 * channel) };
}

/** `bytes` as a data URI. The bytes themselves tell the image format. */
export const dataUri = (bytes) => `data:image/png;base64,${bytes.toString('base64')}`;
