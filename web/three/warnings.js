// Warnings of what isn't supported, each once in the console.

export class Warnings {
  #told = new WeakMap(); // sentences by object

  /** `object`: the object of three.js that the sentence is about. */
  warn(object, sentence) {
    const told = this.#told.get(object) ?? new Set();
    if (told.has(sentence)) return;
    this.#told.set(object, told.add(sentence));
    console.warn(sentence);
  }
}
