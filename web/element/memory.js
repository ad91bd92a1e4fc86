// Access to the program's memory.

/**
 * Copies bytes into the program's memory; returns [address, size]. Whoever receives these frees
 * them.
 */
export const putBytes = (program, bytes) => putParts(program, [bytes]);

/** The same for bytes in several parts, which are joined. */
export function putParts(program, parts) {
  const size = parts.reduce((sum, { byteLength }) => sum + byteLength, 0);
  const address = program._malloc(Math.max(size, 1));
  if (!address) throw new Error('This needs more memory than the browser allows a page.');
  let to = address;
  for (const part of parts) {
    program.HEAPU8.set(part, to);
    to += part.byteLength;
  }
  return [address, size];
}
