// How much a test repeats: ./test --long sets EDGESHADE_LONG.

export const isLong = Boolean(process.env.EDGESHADE_LONG);

/** `usual` repetitions, or `long` under ./test --long. */
export const times = (usual, long) => (isLong ? long : usual);
