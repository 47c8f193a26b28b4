// `npm run pictures`: renders the pictures that README and docs show, and the gallery's thumbnails, with the program's own
// command line. `npm run pictures -- street` makes those of some scenes.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { checkNode, ensureBuilt, ensureModules, root, run, SetupError } from './setup.mjs';

/** Scene, name of the picture, flags. Thumbnails are 480 × 270, pictures for docs 960 × 540. */
const thumbnails = {
  street: ['--time', '5', '--beta', '0,0,-0.2'],
  dice: [],
  wheel: [],
  lattice: [],
  sphere: [],
  hall: ['--time', '4.6', '--beta', '0,0,-0.2'],
  saturn: ['--time', '7.7', '--beta', '0,0,-0.1', '--fov', '44'],
  gallery: ['--time', '4.6', '--beta', '0,0,-0.2'],
  ladder: [],
};
const shape = ['--doppler-mix', '0', '--beaming', '0'];
const pictures = [
  ['street', 'street-rest', ['--time', '6.5', '--beta', '0,0,0']],
  ['street', 'street-shape', ['--time', '6.5', '--beta', '0,0,-0.9', ...shape]],
  ['street', 'street-light', ['--time', '6.5', '--beta', '0,0,-0.9']],
  ['dice', 'dice-seen', []],
  ['dice', 'dice-there', ['--view', 'simultaneity']],
];

try {
  checkNode();
  ensureModules();
  ensureBuilt('lib', 'app');
  const wanted = process.argv.slice(2);
  const chosen = (scene) => wanted.length === 0 || wanted.includes(scene);
  mkdirSync(join(root, 'docs/pictures'), { recursive: true });
  mkdirSync(join(root, 'examples/thumbnails'), { recursive: true });
  for (const [scene, flags] of Object.entries(thumbnails))
    if (chosen(scene)) render(scene, `examples/thumbnails/${scene}.png`, ['--size', '480x270', ...flags]);
  for (const [scene, name, flags] of pictures)
    if (chosen(scene)) render(scene, `docs/pictures/${name}.png`, ['--size', '960x540', ...flags]);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run pictures: ${error.message}`);
  process.exit(1);
}

function render(scene, out, flags) {
  run(process.execPath, [
    join(root, 'bin/slowlight.js'),
    'render',
    `examples/${scene}.usda`,
    '-o',
    out,
    '--samples',
    '3',
    ...flags,
  ]);
}
