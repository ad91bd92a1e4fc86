// Numbers on their way into a program's memory.

/** Copies typed arrays there, calls use(addresses) and frees them again. */
export function withCopies(program, arrays, use) {
  const addresses = [];
  try {
    for (const array of arrays) {
      const address = program._malloc(Math.max(array.byteLength, 1));
      if (!address) throw new Error('That needs more memory than the browser gives a page.');
      addresses.push(address);
      program.HEAPU8.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), address);
    }
    return use(addresses);
  } finally {
    for (const address of addresses) program._free(address);
  }
}

/** {positions, indices} as the program wants them: Float32Array, Uint32Array. */
export function meshNumbers({ positions, indices }) {
  const floats = positions instanceof Float32Array ? positions : Float32Array.from(positions);
  if (indices) return [floats, indices instanceof Uint32Array ? indices : Uint32Array.from(indices)];
  return [floats, Uint32Array.from({ length: floats.length / 3 }, (_, i) => i)];
}
