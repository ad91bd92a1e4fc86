// Passes numbers into a program's memory.

/** Copies typed arrays into it, calls use(addresses) and frees them again. */
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

const floatsOf = (numbers) => (numbers instanceof Float32Array ? numbers : Float32Array.from(numbers));

/** A mesh in the program's form: {positions, indices, texcoords} as typed arrays, and flags. */
export function meshNumbers({ positions, indices, texcoords = [], casts = true, doubleSided = true, bends = false, alphaTested = false, visible = true }) {
  const floats = floatsOf(positions);
  const corners = indices ?? { length: floats.length / 3 };
  return {
    positions: floats,
    indices: corners instanceof Uint32Array ? corners : Uint32Array.from(corners, (corner, i) => corner ?? i),
    texcoords: floatsOf(texcoords),
    flags: [casts, doubleSided, bends, alphaTested, visible].reduce((sum, on, bit) => sum + (on ? 1 << bit : 0), 0),
  };
}

/**
 * Copies meshNumbers() into the program's memory and calls use() with the arguments that it takes.
 */
export function withMesh(program, { positions, indices, texcoords, flags }, use) {
  return withCopies(program, [positions, indices, texcoords], ([p, i, t]) =>
    use(p, positions.length, i, indices.length, t, texcoords.length, flags));
}
