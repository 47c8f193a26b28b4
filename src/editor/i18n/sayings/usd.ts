/** What the readers and the composition of USD say; written as `sayings/index.ts` tells. */
export const usd: Readonly<Record<string, string>> = {};
