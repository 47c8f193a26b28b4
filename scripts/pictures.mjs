// `npm run pictures`: renders the pictures of README and docs and the gallery's thumbnails with the command line.
// `npm run pictures -- street` renders those of some scenes. The comparisons of docs/guide/comparing.md are only made by
// `npm run pictures -- compare` (or the name of one, `compare-moved`), since the reference renderer is slow.
import { copyFileSync, existsSync, mkdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { paintClockFilm } from './clockFilm.mjs';
import { drawIcons, shootGraph } from './pageShots.mjs';
import { checkNode, ensureBuilt, ensureModules, root, run, SetupError } from './setup.mjs';
import { toWebp } from './webp.mjs';

/** Scene, name of the picture, flags. Thumbnails are 480 × 270, pictures for docs 960 × 540. */
const thumbnails = {
  street: ['--time', '5', '--beta', '0,0,-0.2'],
  dice: [],
  wheel: [],
  lattice: ['--exposure', '2.5'],
  sphere: [],
  hall: ['--time', '4.6', '--beta', '0,0,-0.2'],
  lamps: [],
  prism: ['--fov', '30', '--exposure', '0.6'],
  sunset: [],
  starfield: [],
  saturn: ['--time', '7.7', '--beta', '0,0,-0.1', '--fov', '44'],
  gallery: ['--time', '4.6', '--beta', '0,0,-0.2'],
  ladder: [],
  twins: [],
  cubes: ['--beta', '0,0,-0.2'],
  arcade: ['--beta', '0,0,-0.2'],
  boxes: ['--beta', '0,0,-0.2'],
  drops: [],
  plain: [],
  rush: ['--exposure', '2.5'],
  captured: [],
  'texture-cube': [],
  'texture-hall': [],
  'texture-interior': [],
  'clocks-around': ['--time', '0.9', '--beta', '0,0,-0.6'],
  'boxes-892': [],
  'boxes-949': [],
  'boxes-968': [],
  workshop: [],
  layers: ['--time', '5'],
  checkerboards: [],
  comparison: [],
  lesson: [],
  'gods-eye': [],
  letters: [],
  'hanging-cloth': [],
  'falling-cloth': [],
  impact: [],
  bouncing: [],
  pendulums: [],
  cradle: [],
  charges: [],
  'source-speeds': [],
  'source-corrections': [],
  'source-ball': [],
  truth: ['--set', 'truth.width=384', '--set', 'truth.height=216', '--set', 'truth.samples=4'],
};
const shape = ['--doppler-mix', '0', '--beaming', '0'];
/** The street at 0.9 c, looked at from behind and above. */
const held = ['--time', '6.5', '--beta', '0,0,-0.9', '--vantage', '0,25,30', '--look-at', '0,0,-20'];
const half = ['--time', '5', '--beta', '0,0,-0.5'];
const pictures = [
  ['street', 'street-rest', ['--time', '6.5', '--beta', '0,0,0']],
  ['street', 'street-shape', ['--time', '6.5', '--beta', '0,0,-0.9', ...shape]],
  ['street', 'street-light', ['--time', '6.5', '--beta', '0,0,-0.9']],
  ['street', 'street-held', [...held, ...shape]],
  ['street', 'street-dome', [...half, '--lens', 'dome', '--dome-tilt', '20', '--size', '640x640']],
  ['street', 'street-around', [...half, '--lens', 'equirectangular', '--size', '960x480']],
  ...['doppler', 'emission-time', 'radiance', 'band'].map((what) => [
    'sphere',
    `false-${what}`,
    ['--size', '480x270', '--beta=-0.1,0,-0.5', '--false-colour', what, '--legend'],
  ]),
  ...['spectral', 'approximate', 'two-wavelengths', 'linear-spectrum'].map((colors) => [
    'street',
    `colors-${colors}`,
    ['--size', '480x270', '--time', '5', '--beta', '0,0,-0.35', '--colors', colors],
  ]),
  ['texture-hall', 'texture-hall', []],
  ['dice', 'occlusion-off', ['--size', '480x270', '--occlusion-radius', '0']],
  ['dice', 'occlusion-on', ['--size', '480x270']],
  ['dice', 'dice-seen', []],
  ['dice', 'dice-there', ['--view', 'simultaneity']],
];
/** Scene, name of the diagram, flags; of docs/guide/diagrams.md. */
const diagrams = [
  [
    'ladder',
    'spacetime-ladder',
    [
      '--time',
      '10',
      '--position',
      '0,2,0',
      '--beta',
      '0.6,0,0',
      '--span',
      '16',
      '--prim',
      '/World/Ladder',
      '--prim',
      '/World/Doors',
    ],
  ],
  [
    'dice',
    'spacetime-dice',
    ['--prim', '/World/Ivory0', '--prim', '/World/Blue4', '--second-axis', '1,0,0', '--beta', '0,0,-0.5'],
  ],
  ['boxes-892', 'energy-over-speed', ['--of', 'energy']],
];
/** Scene, name of the picture, compared format, flags of both, flags of the rasterizer and of `compare`. */
const there = ['--aov', 'position,object'];
const comparisons = [
  ['wheel', 'compare-flip', 'png', ['--size', '240x135', '--samples', '6'], [], ['--triptych']],
  [
    'street',
    'compare-moved',
    'exr',
    ['--size', '432x243', '--time', '6.5', '--beta', '0,0,-0.9', ...there],
    [],
    ['--metric', 'aov', '--max', '0.5'],
  ],
  ['dice', 'compare-newton', 'exr', there, ['--solver', 'newton', '--iterations', '2'], ['--metric', 'aov']],
];

try {
  checkNode();
  ensureModules();
  ensureBuilt('lib', 'app');
  const names = process.argv.slice(2);
  const chosen = (scene) => names.length === 0 || names.includes(scene);
  mkdirSync(join(root, 'docs/pictures'), { recursive: true });
  mkdirSync(join(root, 'examples/thumbnails'), { recursive: true });
  mkdirSync(join(root, '.cache/pictures'), { recursive: true });
  for (const [scene, flags] of Object.entries(thumbnails))
    if (chosen(scene)) draw(scene, `examples/thumbnails/${scene}.webp`, ['--size', '480x270', ...flags]);
  for (const [scene, name, flags] of pictures)
    if (chosen(scene)) draw(scene, `docs/pictures/${name}.webp`, ['--size', '960x540', ...flags]);
  for (const [scene, name, flags] of diagrams)
    if (chosen(scene))
      slowlight('diagram', fileOf(scene), '-o', `docs/pictures/${name}.svg`, '--size', '960x540', ...flags);
  if (chosen('graph')) await shootGraph();
  if (chosen('icons')) await drawIcons();
  if (names.includes('interior')) paintInterior();
  if (names.includes('clocks')) paintClockFilm('examples/panoramas/clocks.mp4');
  for (const comparison of comparisons)
    if (names.includes('compare') || names.includes(comparison[1])) compare(...comparison);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run pictures: ${error.message}`);
  process.exit(1);
}

/** The hall as a panorama of light: three quarters of an hour on two cores, so only when it is asked for. */
function paintInterior() {
  const [light, packed] = ['.cache/pictures/interior.exr', '.cache/pictures/interior'];
  const from = ['--position', '0,2.2,6', '--look-at', '0,2.2,-10', '--beta', '0,0,0', '--time', '4'];
  const how = ['--pipeline', 'reference', '--samples', '10', '--lens', 'equirectangular', '--size', '768x384'];
  slowlight('render', fileOf('hall'), '-o', light, '--aov', 'beauty', ...from, ...how);
  // As the light of a scene it has half as many bits.
  mkdirSync(join(root, packed), { recursive: true });
  slowlight('convert', light, `${packed}/surroundings.usda`);
  copyFileSync(join(root, packed, 'textures/interior.exr'), join(root, 'examples/panoramas/interior.exr'));
}

/** Renders a picture and packs it. */
function draw(scene, out, flags) {
  const png = `.cache/pictures/${basename(out, '.webp')}.png`;
  render(scene, png, flags);
  toWebp(png, out, { exact: flags.includes('--false-colour') });
}

function fileOf(scene) {
  return [`examples/${scene}.usdc`, `examples/${scene}.slowlight.json`].find((path) => existsSync(join(root, path)));
}

function render(scene, out, flags) {
  slowlight('render', fileOf(scene), '-o', out, '--samples', '3', ...flags);
}

/** Compares the rasterizer's picture with that of the reference renderer. */
function compare(scene, name, format, both, fast, how) {
  const [a, b] = ['raster', 'reference'].map((pipeline) => {
    const out = `.cache/pictures/${name}-${pipeline}.${format}`;
    const flags = pipeline === 'raster' ? fast : [];
    render(scene, out, ['--size', '480x270', '--pipeline', pipeline, ...both, ...flags]);
    return out;
  });
  const png = `.cache/pictures/${name}.png`;
  slowlight('compare', a, b, '-o', png, ...how);
  toWebp(png, `docs/pictures/${name}.webp`, { exact: how.includes('aov') });
}

function slowlight(...args) {
  run(process.execPath, [join(root, 'bin/slowlight.js'), ...args]);
}
