// Releases of three.js, and devices, that edgeshade/three-webgpu works with.

/** The first in which lights' shadow nodes can make three.js bind their textures again. */
const first = 187;

/** Throws a sentence for others. `revision`: three.js's REVISION. */
export function requireRelease(revision) {
  if (!(parseInt(revision, 10) >= first)) throw new Error(`ExactShadows of edgeshade/three-webgpu needs r${first} of three.js or later, not r${revision}.`);
}

/**
 * Throws a sentence for devices whose fragment shaders have no 32-bit floats and integers. WebGPU's have by its
 * specification. `backend`: of an initialised WebGPURenderer.
 */
export function requireFloats({ isWebGLBackend, gl }) {
  if (!isWebGLBackend) return;
  const [floats, integers] = [gl.HIGH_FLOAT, gl.HIGH_INT].map((kind) => gl.getShaderPrecisionFormat(gl.FRAGMENT_SHADER, kind));
  const { precision, rangeMin, rangeMax } = floats;
  if (!(precision >= 23 && rangeMin >= 126 && rangeMax >= 126))
    throw new Error(`ExactShadows needs fragment shaders with 32-bit floats: this device's have ${precision} binary digits, and exponents from -${rangeMin} to ${rangeMax}.`);
  if (!(integers.rangeMax >= 30)) throw new Error(`ExactShadows needs fragment shaders with 32-bit integers: this device's have ${integers.rangeMax + 1} bits.`);
}
