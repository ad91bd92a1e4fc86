// The releases of three.js that edgeshade/three-webgpu works with.

/** The first in which lights' shadow nodes can make three.js bind their textures again. */
const first = 187;

/** Throws a sentence for others. `revision`: three.js's REVISION. */
export function requireRelease(revision) {
  if (!(parseInt(revision, 10) >= first)) throw new Error(`ExactShadows of edgeshade/three-webgpu needs r${first} of three.js or later, not r${revision}.`);
}
