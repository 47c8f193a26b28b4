/** What is said of all other files: OBJ, PLY, STL, zip, pictures, tables, fonts; written as `sayings/index.ts` tells. */
export const files: Readonly<Record<string, string>> = {};
