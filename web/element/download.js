// Fetches a scene and the files that a .gltf names.

import { requireReadableSize } from './files.js';
import { outsideFilesOf } from './virtual-folder.js';

async function responseTo(address, name) {
  let response;
  try {
    response = await fetch(address);
  } catch {
    throw new Error(`'${name}' could not be fetched from ${address.host || 'there'}: there is no ` +
      'connection, or that server does not allow this page to fetch it.');
  }
  if (response.status === 404) throw new Error(`'${name}' was not found: the server answered 404.`);
  if (!response.ok)
    throw new Error(`'${name}' could not be fetched: the server answered ${response.status}.`);
  return response;
}

async function bytesOf(address, name, onFraction) {
  const response = await responseTo(address, name);
  // The length of a compressed answer differs from that of its content.
  const known = response.headers.has('content-encoding') ? 0
    : Number(response.headers.get('content-length'));
  requireReadableSize(name, known);
  const parts = [];
  let length = 0;
  const reader = response.body.getReader();
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw new Error(`The download of '${name}' was interrupted.`);
    });
    if (done) break;
    parts.push(value);
    length += value.byteLength;
    requireReadableSize(name, length);
    onFraction(known > 0 ? Math.min(1, length / known) : 0);
  }
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.byteLength;
  }
  return bytes;
}

/** The bytes of a file that the scene at `url` names. */
export const downloadBeside = (url, uri, path) => bytesOf(new URL(uri, url), path, () => {});

/** The scene and its buffers: {name, files: Map of paths to bytes}. Images may come later. */
export async function download(url, onFraction) {
  const address = new URL(url);
  const name = decodeURIComponent(address.pathname.split('/').pop()) || 'scene.glb';
  const bytes = await bytesOf(address, name, onFraction);
  const files = new Map([[name, bytes]]);
  for (const { uri, path } of outsideFilesOf(bytes, ['buffers']))
    files.set(path, await downloadBeside(url, uri, path));
  return { name, files };
}
