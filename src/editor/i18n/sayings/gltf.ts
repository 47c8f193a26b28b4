/** What the readers and writers of glTF say; written as `sayings/index.ts` tells. */
export const gltf: Readonly<Record<string, string>> = {};
