import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { FONTS, fontFile } from '../../src/formats/font/glyphs.ts';
import { root } from './root.ts';

/** Ships the fonts of solid letters beside the page, which reads the files that it needs; and their licences. */
export function fonts(): Plugin {
  return {
    name: 'slowlight-fonts',
    generateBundle() {
      for (const { name, weight } of FONTS) {
        const folder = join(root, 'node_modules/@fontsource', name);
        const subsets = Object.keys(JSON.parse(readFileSync(join(folder, 'unicode.json'), 'utf8')));
        const files = subsets.map((subset) => fontFile({ name, weight }, subset));
        for (const file of ['LICENSE', 'unicode.json', ...files])
          this.emitFile({ type: 'asset', fileName: `fonts/${name}/${file}`, source: readFileSync(join(folder, file)) });
      }
    },
  };
}
