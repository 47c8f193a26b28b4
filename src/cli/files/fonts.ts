import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import type { ReadFont } from '../../formats/font/glyphs.ts';

const { resolve } = createRequire(import.meta.url);

/** Reads fonts from the installed npm packages. */
export const readFont: ReadFont = async (path) => new Uint8Array(await readFile(resolve(`@fontsource/${path}`)));
