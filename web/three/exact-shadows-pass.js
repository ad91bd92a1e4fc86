// A pass for EffectComposer that draws a scene with exact shadows.

import { Color } from 'three';

/**
 * In place of RenderPass, with its settings. It has the members of the addon's Pass without
 * importing it, so that pages need no address for addons.
 */
export class ExactShadowsPass {
  isPass = true;
  isRenderPass = true;
  enabled = true;
  needsSwap = false;
  clear = true;
  clearDepth = false;
  renderToScreen = false;
  #before = new Color();

  constructor(shadows, scene, camera, overrideMaterial = null, clearColor = null, clearAlpha = null) {
    Object.assign(this, { shadows, scene, camera, overrideMaterial, clearColor, clearAlpha });
  }

  /** Sets nothing: each picture has its target's size. */
  setSize() {}

  dispose() {}

  render(renderer, writeBuffer, readBuffer) {
    const { shadows, scene, camera, clearColor, clearAlpha } = this;
    const { autoClear } = renderer, { overrideMaterial } = scene, alpha = renderer.getClearAlpha();
    renderer.getClearColor(this.#before);
    renderer.autoClear = false;
    if (this.overrideMaterial) scene.overrideMaterial = this.overrideMaterial;
    if (clearColor !== null || clearAlpha !== null) renderer.setClearColor(clearColor ?? this.#before, clearAlpha ?? alpha);
    try {
      renderer.setRenderTarget(this.renderToScreen ? null : readBuffer);
      if (this.clear) renderer.clear(renderer.autoClearColor, renderer.autoClearDepth, renderer.autoClearStencil);
      else if (this.clearDepth) renderer.clearDepth();
      shadows.render(scene, camera);
    } finally {
      renderer.setClearColor(this.#before, alpha);
      if (this.overrideMaterial) scene.overrideMaterial = overrideMaterial;
      renderer.autoClear = autoClear;
    }
  }
}
