// A GL whose drawing calls do nothing, so that a page's times are those of its threads alone, as with a graphics card
// that keeps up. Fences are signalled soon, as nothing is drawn before them; what is read back is what was uploaded or
// cleared before.

const draws = /^(draw(Arrays|Elements|RangeElements)|multiDraw|clear($|Buffer)|blitFramebuffer)/;

/** From now on nothing is drawn in this context. */
export function drawNothing(gl) {
  const idle = (owner) => {
    for (const name in owner) if (draws.test(name) && typeof owner[name] === 'function') owner[name] = () => {};
    return owner;
  };
  idle(gl);
  const { getExtension } = gl;
  gl.getExtension = (name) => {
    const found = getExtension.call(gl, name);
    return found && idle(found);
  };
}
