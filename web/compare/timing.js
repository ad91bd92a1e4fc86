// Frame times, each measured until the picture is finished.

export const frameStart = () => new Promise((resolve) => { requestAnimationFrame(resolve); });

/** Returns when the context has drawn everything, because a pixel can only be read then. */
export function finish(context) {
  context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

const round = (value) => Number(value.toFixed(3));

/** {median, least, most} of milliseconds; null if there are none. */
export const spreadOf = (times) => (times.length === 0 ? null
  : { median: round(median(times)), least: round(Math.min(...times)), most: round(Math.max(...times)) });

/**
 * Times on the GPU itself, if the context has timer queries; otherwise every method does nothing.
 */
export class GpuTimer {
  #gl;
  #extension;
  #running = [];
  #times = [];

  constructor(gl) {
    this.#gl = gl;
    this.#extension = gl.getExtension('EXT_disjoint_timer_query_webgl2');
  }

  get there() {
    return this.#extension !== null;
  }

  begin() {
    if (!this.there) return;
    const query = this.#gl.createQuery();
    this.#gl.beginQuery(this.#extension.TIME_ELAPSED_EXT, query);
    this.#running.push(query);
  }

  end() {
    if (this.there) this.#gl.endQuery(this.#extension.TIME_ELAPSED_EXT);
  }

  /**
   * Milliseconds of each begin() since the last call, except those that the GPU reports as
   * disturbed.
   */
  async take() {
    const gl = this.#gl;
    for (let tries = 0; this.#running.length && tries < 100; ++tries) {
      await frameStart(); // results arrive between tasks
      const disturbed = gl.getParameter(this.#extension.GPU_DISJOINT_EXT);
      this.#running = this.#running.filter((query) => {
        if (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) return true;
        if (!disturbed) this.#times.push(gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6);
        gl.deleteQuery(query);
        return false;
      });
    }
    for (const query of this.#running.splice(0)) gl.deleteQuery(query);
    return this.#times.splice(0);
  }
}
