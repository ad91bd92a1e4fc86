// How long edgeshade's own steps hold the page's thread: in frames, between them, and on workers' answers.

/** Microtasks in a row that may follow from a step. */
const mostMicrotasks = 50;

/**
 * Times all later steps of engines that are created after this call: timers, and answers of workers. Returns
 * {steps, map, follow(shadows)}; `steps`: {at, ms, what} of each, milliseconds; `map`: when the last map was sent to
 * its worker, and when it came; follow() times the masks of frames, too.
 */
export function watchSteps() {
  const steps = [], map = { askedAt: null, cameAt: null };
  const note = (what, at) => steps.push({ what, at, ms: performance.now() - at });
  const timed = (what, act) => async function (...given) {
    const at = performance.now();
    act.apply(this, given);
    for (let i = 0; i < mostMicrotasks; ++i) await undefined;
    note(what, at);
  };
  const { setTimeout: original } = window;
  window.setTimeout = (act, ...given) => original(typeof act === 'function' ? timed('timer', act) : act, ...given);
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...given) {
    if (message.task) map.askedAt = performance.now();
    return postMessage.call(this, message, ...given);
  };
  const { set } = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage');
  const answered = (act) => timed('answer', function (event) {
    if (event.data.result?.texels) map.cameAt = performance.now();
    act.call(this, event);
  });
  Object.defineProperty(Worker.prototype, 'onmessage', { set(act) { set.call(this, act && answered(act)); }, configurable: true });
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
  return { steps, map, follow };
}
