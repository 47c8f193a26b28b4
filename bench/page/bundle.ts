import { readdirSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Bench } from '../support/bench.ts';

const app = fileURLToPath(new URL('../../../../dist/app/', import.meta.url));

export const bundle: Bench = {
  name: 'bundle',
  title: 'Size of the page',
  about:
    '*First load*: what index.html names, and what that imports before it runs. *All*: every script and style, with the readers that are fetched when a file of their kind is opened.',
  async run() {
    const assets = readdirSync(join(app, 'assets')).filter((file) => ['.js', '.css'].includes(extname(file)));
    const first = new Set(
      [...readFileSync(join(app, 'index.html'), 'utf8').matchAll(/assets\/([^"]+\.(?:js|css))/g)].map((m) => m[1]),
    );
    const row = (label: string, files: readonly string[]) => {
      const contents = files.map((file) => readFileSync(join(app, 'assets', file)));
      const sum = (size: (bytes: Buffer) => number): number =>
        contents.reduce((total, bytes) => total + size(bytes), 0) / 1024;
      return [
        label,
        String(files.length),
        sum((bytes) => bytes.length),
        sum((bytes) => gzipSync(bytes, { level: 9 }).length),
      ];
    };
    return [
      {
        columns: ['', 'files', 'size [KiB]', 'gzipped [KiB]'],
        rows: [
          row(
            'first load',
            assets.filter((file) => first.has(file)),
          ),
          row('all', assets),
        ],
      },
    ];
  },
};
