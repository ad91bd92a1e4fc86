// Access to the program's memory.

/**
 * Copies bytes into the program's memory; returns [address, size]. Whoever receives these frees
 * them.
 */
export function putBytes(program, bytes) {
  const address = program._malloc(Math.max(bytes.byteLength, 1));
  if (!address) throw new Error('This needs more memory than the browser allows a page.');
  program.HEAPU8.set(bytes, address);
  return [address, bytes.byteLength];
}
