// How long edgeshade's own steps hold the page's thread: in frames, between them, and on workers' answers.

/** Microtasks in a row that may follow from a step. */
const mostMicrotasks = 50;

/**
 * Times all later steps of engines that are created after this call: timers, and answers of workers. Returns
 * {steps, follow(shadows)}; `steps`: {at, ms, what} of each, milliseconds; follow() times the masks of frames, too.
 */
export function watchSteps() {
  const steps = [];
  const note = (what, at) => steps.push({ what, at, ms: performance.now() - at });
  const timed = (what, act) => async function (...given) {
    const at = performance.now();
    act.apply(this, given);
    for (let i = 0; i < mostMicrotasks; ++i) await undefined;
    note(what, at);
  };
  const { setTimeout: original } = window;
  window.setTimeout = (act, ...given) => original(typeof act === 'function' ? timed('timer', act) : act, ...given);
  const { set } = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage');
  Object.defineProperty(Worker.prototype, 'onmessage', { set(act) { set.call(this, act && timed('answer', act)); }, configurable: true });
  const follow = (shadows) => {
    for (const name of ['beginMasks', 'endMasks']) {
      const act = shadows[name].bind(shadows);
      shadows[name] = (...given) => {
        const at = performance.now();
        try {
          return act(...given);
        } finally {
          note(name, at);
        }
      };
    }
    return shadows;
  };
  return { steps, follow };
}
