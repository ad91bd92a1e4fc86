// The element's WebGL 1 context: created, checked, and registered with the program.

/** Returns the context, or throws an Error whose message is a sentence. */
export function createContext(canvas, { antialias }) {
  const context = canvas.getContext('webgl', {
    alpha: true,
    antialias,
    depth: true,
    stencil: true,
    powerPreference: 'high-performance',
  });
  if (!context)
    throw new Error('This browser provides no WebGL here, which the viewer needs. It may be ' +
      'switched off, or the browser does not trust the graphics driver.');
  if (!context.getContextAttributes()?.stencil)
    throw new Error('This browser provides a WebGL context without a stencil buffer, which ' +
      'shadow volumes need.');
  return context;
}

/** Makes the context the program's current one. Returns a handle for makeCurrent(). */
export function register(program, context) {
  const handle = program.GL.registerContext(context, {
    majorVersion: 1,
    minorVersion: 0,
    enableExtensionsByDefault: true,
  });
  program.GL.makeContextCurrent(handle);
  return handle;
}

/** Unregisters it: after a loss it must be registered again. */
export function unregister(program, handle) {
  program.GL.deleteContext(handle);
}
