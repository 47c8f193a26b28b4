// `npm run stars`: regenerates src/scene/stars/catalogue.ts from the npm package d3-celestial (BSD-3-Clause), whose source is XHIP.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { root } from './setup.mjs';

const PACKAGE = 'd3-celestial@0.7.35';
const folder = mkdtempSync(join(tmpdir(), 'slowlight-stars-'));
try {
  const archive = execFileSync('npm', ['pack', PACKAGE, '--silent'], { cwd: folder, encoding: 'utf8' }).trim();
  execFileSync('tar', ['xzf', archive], { cwd: folder });
  const { features } = JSON.parse(readFileSync(join(folder, 'package/data/stars.6.json'), 'utf8'));
  const stars = features
    .map(({ properties: { mag, bv }, geometry: { coordinates } }) => [...coordinates, mag, Number(bv || 0.6)])
    .sort((a, b) => a[2] - b[2]);
  const bytes = Buffer.alloc(12 * stars.length);
  stars.forEach(([rightAscension, declination, magnitude, colorIndex], i) => {
    bytes.writeInt32LE(Math.round(1e4 * rightAscension), 12 * i);
    bytes.writeInt32LE(Math.round(1e4 * declination), 12 * i + 4);
    bytes.writeInt16LE(Math.round(100 * magnitude), 12 * i + 8);
    bytes.writeInt16LE(Math.round(1000 * colorIndex), 12 * i + 10);
  });
  writeFileSync(join(root, 'src/scene/stars/catalogue.ts'), moduleOf(bytes, stars.length));
  console.log(`${stars.length} stars of ${PACKAGE}`);
} finally {
  rmSync(folder, { recursive: true });
}

function moduleOf(bytes, count) {
  return `/**
 * The ${count} stars up to magnitude 6, brightest first, in base64: right ascension and declination (J2000) [10⁻⁴ °] as little-endian int32, V [0.01 mag] and
 * B − V [0.001 mag] as int16; stars without B − V are given 0.6. Made by \`npm run stars\`. Source: XHIP, Anderson & Francis 2012 (VizieR V/137D), as in
 * ${PACKAGE}, Copyright (c) 2015, Olaf Frohn, BSD-3-Clause.
 */
export const CATALOGUE =
  '${bytes.toString('base64')}';
`;
}
