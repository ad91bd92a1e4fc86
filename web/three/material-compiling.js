// Compiles materials before they are drawn, by three.js's compileAsync() where there is one.

export class MaterialCompiling {
  #renderer;
  #versions = new WeakMap(); // by material: the version that was compiled here

  constructor(renderer) {
    this.#renderer = renderer;
  }

  /** Whether any of these materials would compile when it is drawn. */
  waits(materials) {
    return materials.some((material) => material.version !== this.#versions.get(material) &&
      material.version !== this.#renderer.properties.get(material).__version);
  }

  /**
   * Resolves once the scene's programs can be drawn with. Early releases of three.js, and browsers that can't
   * say when a program is compiled, only begin to. `materials`: those that waits() asks about.
   */
  async compile(scene, camera, materials) {
    const renderer = this.#renderer;
    const tells = renderer.getContext().getExtension('KHR_parallel_shader_compile'); // three.js warns without it
    if (renderer.compileAsync && tells) await renderer.compileAsync(scene, camera);
    else renderer.compile(scene, camera);
    for (const material of materials) this.#versions.set(material, material.version);
  }
}
