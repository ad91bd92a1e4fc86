// One progress bar from the element's start to the first frame.

// Start and end of each stage on the bar.
const spans = {
  start: [0, 0.04, 'Starting'],
  download: [0.04, 0.5, 'Fetching the scene'],
  read: [0.5, 0.58, 'Reading the scene'],
  flatten: [0.58, 0.64, 'Placing the parts'],
  images: [0.64, 0.72, 'Loading the images'],
  shadows: [0.72, 0.86, 'Finding the edges'],
  'hand over': [0.86, 0.9, 'Transferring the scene'],
  upload: [0.9, 0.98, 'Uploading to the GPU'],
  draw: [0.98, 1, 'Drawing the first frame'],
};

export class Progress {
  #box;
  constructor(box) {
    this.#box = box;
  }

  /** Returns the progress of the whole load, 0..1. */
  show(stage, fraction = 0) {
    const [from, to, words] = spans[stage];
    const done = from + (to - from) * fraction;
    this.#box.hidden = false;
    this.#box.setAttribute('aria-valuenow', String(Math.round(100 * done)));
    this.#box.setAttribute('aria-valuetext', words);
    this.#box.querySelector('.bar > div').style.width = `${100 * done}%`;
    this.#box.querySelector('.stage').textContent = `${words} … ${Math.round(100 * done)} %`;
    return done;
  }

  hide() {
    this.#box.hidden = true;
  }
}
