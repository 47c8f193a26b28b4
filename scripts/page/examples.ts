import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import type { Plugin } from 'vite';
import type { Example } from '../../src/editor/loading/examples.ts';
import { readLayer } from '../../src/formats/usd/readLayer.ts';
import { hintsOf } from '../../src/formats/usd/schema/slowlightAttributes.ts';
import { root } from './root.ts';

const examplesFolder = join(root, 'examples');
/** The order of the gallery: from what everybody knows to what needs a thought. Others follow by name. */
const GALLERY = [
  'street',
  'dice',
  'wheel',
  'starfield',
  'lamps',
  'sphere',
  'lattice',
  'prism',
  'sunset',
  'hall',
  'saturn',
  'gallery',
  'ladder',
  'cubes',
  'arcade',
  'boxes',
  'drops',
  'plain',
  'rush',
  'captured',
  'texture-cube',
  'texture-hall',
  'texture-interior',
  'clocks-around',
  'boxes-892',
  'boxes-949',
  'boxes-968',
  'comparison',
  'layers',
  'lesson',
  'gods-eye',
  'letters',
  'truth',
  'workshop',
];
const SCENES = ['.usda', '.usdc'];
const isProject = (file: string): boolean => file.endsWith('.slowlight.json');
const SHIPPED = [...SCENES, '.png', '.webp', '.exr', '.mp4'];

/** Ships examples/ beside the page, with an index of what to look for, taken from the scenes' own hints. */
export function examples(): Plugin {
  return {
    name: 'slowlight-examples',
    generateBundle() {
      const files = filesIn(examplesFolder, '').filter((file) => SHIPPED.includes(extname(file)) || isProject(file));
      for (const file of files) {
        const source = readFileSync(join(examplesFolder, file));
        this.emitFile({ type: 'asset', fileName: `examples/${file}`, source });
      }
      const scenes = files.filter((file) => !file.includes('/') && SCENES.includes(extname(file)));
      const shown = [...scenes.map(describe), ...files.filter(isProject).map(describeProject)];
      const index = shown.sort((a, b) => placeOf(a) - placeOf(b));
      this.emitFile({ type: 'asset', fileName: 'examples/index.json', source: JSON.stringify(index) });
    },
  };
}

function filesIn(folder: string, prefix: string): string[] {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) =>
      entry.isDirectory() ? filesIn(join(folder, entry.name), `${prefix}${entry.name}/`) : [prefix + entry.name],
    );
}

function describe(file: string): Example {
  const name = file.slice(0, -extname(file).length);
  const { title = name, lookFor = '' } = hintsOf(readLayer(readFileSync(join(examplesFolder, file)), file));
  return { source: `examples/${file}`, name, title, lookFor, ...thumbnailOf(name) };
}

function describeProject(file: string): Example {
  const name = file.replace('.slowlight.json', '');
  const { title = name, lookFor = '' } = JSON.parse(readFileSync(join(examplesFolder, file), 'utf8'));
  return { source: `examples/${file}`, name, title, lookFor, ...thumbnailOf(name) };
}

function thumbnailOf(name: string): Pick<Example, 'thumbnail'> {
  const thumbnail = `thumbnails/${name}.webp`;
  return existsSync(join(examplesFolder, thumbnail)) ? { thumbnail: `examples/${thumbnail}` } : {};
}

/** Of the examples. */
export function namesOfThumbnails(): readonly string[] {
  return filesIn(join(examplesFolder, 'thumbnails'), '').map((file) => file.slice(0, -extname(file).length));
}

const placeOf = ({ name }: Example): number => (GALLERY.includes(name) ? GALLERY.indexOf(name) : GALLERY.length);
