import fc from 'fast-check';

/** Property tests draw the same cases on every machine; `SEED=$RANDOM npm test` draws others, and a failure prints its seed. */
fc.configureGlobal({ seed: Number(process.env.SEED ?? 20260727) });
