/** What is said of shader text that somebody wrote; written as `sayings/index.ts` tells. */
export const shaderText: Readonly<Record<string, string>> = {};
