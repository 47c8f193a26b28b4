// Jobs of `npm run sameOutputs`: every kind of output of every example, small enough for a software GPU.
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

const RASTER_SIZE = ['--size', '96x54'];
/** One thread, because two processes run at once; the bits do not depend on the number of threads. */
const REFERENCE = ['--pipeline', 'reference', '--size', '48x27', '--samples', '2', '--threads', '1'];
const PIPELINES = {
  webgpu: ['--pipeline', 'raster', '--backend', 'webgpu', ...RASTER_SIZE],
  webgl: ['--pipeline', 'raster', '--backend', 'webgl', ...RASTER_SIZE],
  reference: REFERENCE,
};
export const KINDS = [
  ...Object.keys(PIPELINES),
  ...'compare probe inspect convert graph simulate help usage'.split(' '),
];
/** Names for several kinds. */
export const KIND_GROUPS = { render: ['webgpu', 'webgl'] };

const AOVS = ['--aov', 'beauty,albedo,depth,emission_time,doppler,position,normal,velocity,object'];
const REST = ['--beta', '0,0,0'];
/** 0.6 c, oblique. */
const MOVING = ['--beta', '0.36,0,-0.48'];
const MOTIONS = { 'at rest': REST, '0.6 c': MOVING };
/** Scenes that are rendered with more settings: uniform, sampled and deforming motions. */
const FEW_SCENES = ['dice', 'street', 'wheel'];
/** Projects that are also rendered with WebGL2 and the reference renderer: those with frame graphs, and one simulation. */
const FEW_PROJECTS = ['comparison', 'layers', 'lesson', 'gods-eye', 'truth', 'workshop', 'hanging-cloth'];
const FORMATS = ['usda', 'usdc', 'usdz', 'gltf', 'glb', 'obj'];
export const SCENE_FILE = /\.(usd|usda|usdc|usdz|gltf|glb|obj|ply|stl)$/;
/** A moving object of each scene, if there is one. */
const PROBED = {
  dice: '/World/Ivory0',
  gallery: '/World/Vault',
  hall: '/World/Cube',
  ladder: '/World/Doors/EntryLeft',
  lamps: '/World/Sodium',
  lattice: '/World/BarsAlong',
  prism: '/World/Rail0',
  saturn: '/World/Rhea',
  sphere: '/World/Half',
  starfield: '/World/Gate0',
  street: '/World/CubeAcross',
  sunset: '/World/Road',
  wheel: '/World/Rolling',
};

/** Flags of `render` for a still, several per picture; `only`: the pipelines that support them, `without`: flags that they replace. */
const SETTINGS = [
  { name: 'no light delay', flags: ['--no-light-delay', '--tone', 'agx', '--exposure', '-0.5'] },
  {
    name: 'no aberration',
    flags: [
      '--no-aberration',
      '--colors',
      'approximate',
      '--metering',
      'manual',
      '--exposure',
      '1.5',
      '--tone',
      'linear',
    ],
  },
  {
    name: 'half the Doppler shift',
    flags: ['--doppler-mix', '0.5', '--beaming', '0.2', '--no-shadows', '--metering', 'resting-eye'],
  },
  {
    name: 'newton',
    flags: ['--solver', 'newton', '--iterations', '3', '--damping', '0.8', '--grid'],
    only: ['webgpu', 'webgl'],
  },
  { name: 'no antialiasing', flags: ['--no-antialiasing', '--occlusion-radius', '0'], only: ['webgpu'] },
  { name: 'no antialiasing', flags: ['--no-antialiasing'], only: ['reference'], without: '--samples' },
  { name: 'samples', flags: ['--samples', '3'], without: '--samples' },
  { name: 'other camera', flags: ['--position', '1,1.5,5', '--look-at', '0,0.5,0', '--fov', '70', '--c', '20'] },
  { name: 'doppler', flags: ['--false-colour', 'doppler', '--legend'] },
  { name: 'emission time', flags: ['--false-colour', 'emission-time', '--false-range', '-3:0', '--legend'] },
  { name: 'radiance', flags: ['--false-colour', 'radiance'] },
  { name: 'band', flags: ['--false-colour', 'band'] },
  { name: 'bounces', flags: ['--bounces', '0', '--no-mirrors', '--seed', '7'], only: ['reference'] },
  { name: 'glass', flags: ['--glass', '--bounces', '3'], only: ['reference'] },
];
/** Those of `SETTINGS` that are also rendered with WebGL2; each starts a browser. */
const WEBGL_SETTINGS = ['newton', 'samples', 'doppler'];

/** Reading options as flags of `convert`. */
const READINGS = [
  ['street', 'retimed', ['--speed-factor', '0.5', '--start-offset', '1.5']],
  ['street', 'cubic', ['--interpolation', 'cubic']],
  ['street', 'flying', ['--fly', '/World/CubeAcross=0.3,0,0.4@2', '--fly-shape', 'world']],
  ['dice', 'flying', ['--fly', '/World/Ivory0=0.8,0,0@1']],
  ['everything.usda', 'red', ['--variant', '/World{paint}=red']],
  ['everything.usda', 'blue', ['--variant', '/World{paint}=blue', '--subdivision', '2']],
  ['everything.usda', 'polygons', ['--subdivision', '0']],
  ['movers.usda', 'cubic', ['--interpolation', 'cubic']],
];

const METHODS = [
  'discrete-gradient',
  'implicit-midpoint',
  'leapfrog',
  'yoshida-4',
  'yoshida-6',
  'yoshida-8',
  'semi-implicit-euler',
  'linearly-implicit',
  'local-global',
];

const COMMANDS = ['', 'render', 'probe', 'inspect', 'compare', 'convert', 'simulate', 'graph', 'serve'];
const GRAPH_COMMANDS = ['check', 'upgrade', 'docs'];

/**
 * All jobs for the files of a commit, `paths` relative to `folder`. A job runs the command lines `steps` in its own folder. Jobs with the same `batch` may share a
 * process; `weight`: approximate duration [s]; `thorough` jobs run on demand.
 */
export function jobsFor(folder, paths) {
  const files = paths.filter((path) => SCENE_FILE.test(path) || path.endsWith('.slowlight.json'));
  const examples = (ending) =>
    files
      .filter((path) => path.startsWith('examples/') && path.split('/').length === 2 && ending.test(path))
      .map((path) => ({ name: basename(path).replace(ending, ''), file: join(folder, path) }));
  // Before ADR 28 they were text.
  const scenes = examples(/\.usd[ac]$/);
  const projects = examples(/\.slowlight\.json$/);
  const gallery = new Set([...scenes, ...projects].map(({ file }) => file));
  const others = files
    .filter((path) => SCENE_FILE.test(path) && !gallery.has(join(folder, path)))
    .map((path) => ({ name: basename(path), file: join(folder, path), place: path }));
  return [
    ...scenes.flatMap(sceneJobs),
    ...projects.flatMap(projectJobs),
    ...others.flatMap(fileJobs),
    ...readingJobs([...scenes, ...others]),
    ...settingJobs(scenes),
    ...compareJobs(scenes),
    ...methodJobs(projects),
    ...usageJobs(scenes, others),
    ...helpJobs(),
  ];
}

const WEIGHTS = { webgl: 6, webgpu: 4, reference: 2, simulate: 2 };

function job(kind, subject, name, steps, more = {}) {
  const weight = (WEIGHTS[kind] ?? 0.5) * steps.length;
  return { id: `${subject}/${kind}/${name}`, kind, subject, steps, batch: `${subject} ${kind}`, weight, ...more };
}

const draw = (kind, file, output, ...flags) => ['render', file, '-o', output, ...PIPELINES[kind], ...flags, '--json'];

function sceneJobs({ name, file }) {
  const few = FEW_SCENES.includes(name);
  const still = (kind, view, motion, isQuick) =>
    job(
      kind,
      name,
      `${view} ${motion}`,
      [draw(kind, file, 'picture.exr', '--view', view, ...MOTIONS[motion], ...AOVS)],
      {
        thorough: !isQuick,
      },
    );
  const sequence = (kind, motion, frames, isQuick) =>
    job(
      kind,
      name,
      `sequence ${motion}`,
      [draw(kind, file, 'frame.##.png', '--frames', frames, '--fps', '1', ...MOTIONS[motion])],
      { thorough: !isQuick },
    );
  return [
    still('webgpu', 'light-cone', 'at rest', false),
    still('webgpu', 'light-cone', '0.6 c', true),
    still('webgpu', 'simultaneity', 'at rest', false),
    still('webgpu', 'simultaneity', '0.6 c', true),
    still('webgpu', 'galilean', 'at rest', few),
    still('webgpu', 'galilean', '0.6 c', false),
    sequence('webgpu', 'at rest', '2:4', true),
    sequence('webgpu', '0.6 c', '2:4', few),
    still('webgl', 'light-cone', '0.6 c', true),
    still('webgl', 'simultaneity', '0.6 c', few),
    still('webgl', 'galilean', '0.6 c', false),
    sequence('webgl', '0.6 c', '2:3', few),
    still('reference', 'light-cone', 'at rest', true),
    still('reference', 'light-cone', '0.6 c', true),
    still('reference', 'simultaneity', 'at rest', false),
    still('reference', 'simultaneity', '0.6 c', true),
    still('reference', 'galilean', 'at rest', true),
    still('reference', 'galilean', '0.6 c', false),
    sequence('reference', '0.6 c', '2:3', few),
    ...probeJobs(name, file),
    job('inspect', name, 'summary', [['inspect', file, '--json']]),
    ...convertJobs(name, file),
  ];
}

function probeJobs(name, file) {
  const pixel = (at, view, beta) => [
    ...['probe', file, '--pixel', at, '--size', '128x72', '--view', view, ...beta, '--json'],
  ];
  const prim = ['probe', file, '--prim', PROBED[name] ?? '/World', ...MOVING, '--json'];
  return [
    job('probe', name, 'pixels', [
      pixel('64,40', 'light-cone', MOVING),
      pixel('20,50', 'light-cone', MOVING),
      pixel('70,44', 'light-cone', REST),
      pixel('58,44', 'simultaneity', MOVING),
      pixel('58,44', 'galilean', MOVING),
    ]),
    job('probe', name, 'object', [prim, [...prim, '--view', 'simultaneity']]),
  ];
}

/** Converts to every format, and reads all but the first back. */
function convertJobs(name, file) {
  const [first, ...others] = FORMATS;
  const write = (format) => ['convert', file, `${name}.${format}`, '--json'];
  return [
    job('convert', name, first, [write(first)]),
    ...others.map((format) =>
      job('convert', name, format, [write(format), ['convert', `${name}.${format}`, `${name}-again.usda`, '--json']]),
    ),
  ];
}

/** A scene file outside the gallery: sets of the projects, and inputs of tests. */
function fileJobs({ name, file, place }) {
  const batch = 'other files';
  const light = [
    job('inspect', name, place, [['inspect', file, '--json']], { batch }),
    job('convert', name, `${place} to usda`, [['convert', file, 'scene.usda', '--json']], { batch }),
    job('convert', name, `${place} to glb`, [['convert', file, 'scene.glb', '--json']], { batch }),
  ];
  const pictures = ['webgpu', 'reference'].map((kind) =>
    job(kind, name, place, [draw(kind, file, 'picture.png')], { batch: `other files ${kind}`, thorough: true }),
  );
  return place.startsWith('examples/') ? [...light, ...pictures] : light;
}

const readingJobs = (files) =>
  READINGS.flatMap(([subject, name, flags]) =>
    files
      .filter((each) => each.name === subject)
      .map(({ file }) => job('convert', subject, name, [['convert', file, 'scene.usda', '--json', ...flags]])),
  );

function settingJobs(scenes) {
  const dice = scenes.find(({ name }) => name === 'dice');
  if (!dice) return [];
  return SETTINGS.flatMap(({ name, flags, only = Object.keys(PIPELINES), without }) =>
    only
      .filter((kind) => kind !== 'webgl' || WEBGL_SETTINGS.includes(name))
      .map((kind) => {
        const line = draw(kind, dice.file, 'picture.png', '--time', '2', ...MOVING);
        const at = line.indexOf(without);
        if (at >= 0) line.splice(at, 2);
        return job(kind, 'dice', name, [[...line, ...flags]]);
      }),
  );
}

function compareJobs(scenes) {
  const dice = scenes.find(({ name }) => name === 'dice');
  if (!dice) return [];
  const pair = (ending, ...flags) => [
    draw('reference', dice.file, `a.${ending}`, ...MOVING, ...flags),
    draw('reference', dice.file, `b.${ending}`, ...MOVING, '--view', 'simultaneity', ...flags),
  ];
  const compare = (ending, metric, ...flags) => [
    ...['compare', `a.${ending}`, `b.${ending}`, '--metric', metric, '-o', `${metric}.png`, '--json', ...flags],
  ];
  return [
    job('compare', 'dice', 'png', [
      ...pair('png'),
      compare('png', 'flip', '--triptych'),
      compare('png', 'pixels', '--fail-above', '0'),
    ]),
    job('compare', 'dice', 'exr', [...pair('exr', ...AOVS), compare('exr', 'aov'), compare('exr', 'flip')]),
  ];
}

function projectJobs({ name, file }) {
  const nodes = Object.entries(JSON.parse(readFileSync(file, 'utf8')).nodes);
  const ofType = (...types) => nodes.filter(([, { type }]) => types.includes(type)).map(([id]) => id);
  // A reference still within a project; smaller, for speed.
  const stills = ofType('reference-render').flatMap((id) =>
    ['width=48', 'height=27', 'samples=1'].flatMap((set) => ['--set', `${id}.${set}`]),
  );
  const few = FEW_PROJECTS.includes(name);
  return [
    job('webgpu', name, 'picture', [draw('webgpu', file, 'picture.png', ...stills)], { thorough: true }),
    job('webgpu', name, 'data', [
      draw('webgpu', file, 'picture.####.exr', ...AOVS, ...MOVING, ...stills, '--frames', '1:2', '--fps', '2'),
    ]),
    job('webgl', name, 'picture', [draw('webgl', file, 'picture.png', ...stills)], { thorough: !few }),
    job('reference', name, 'picture', [draw('reference', file, 'picture.exr', ...AOVS, ...stills)], { thorough: !few }),
    ...simulateJobs(name, file, ofType('simulate')),
    ...savedJobs(name, file, {
      stills: ofType('save-image'),
      films: ofType('save-video'),
      scenes: ofType('write-usd'),
    }),
    job('graph', name, 'check and upgrade', [
      ['graph', 'check', file, '--json'],
      ['graph', 'upgrade', file, '-o', 'upgraded.slowlight.json'],
    ]),
  ];
}

const simulateJobs = (name, file, nodes) =>
  nodes.map((node) =>
    job('simulate', name, node, [
      ['simulate', file, '--node', node, '-o', `${node}.usda`, '--csv', `${node}.csv`, '--json'],
    ]),
  );

/** Files that a project's nodes request, with smaller pictures and shorter films. */
function savedJobs(name, file, { stills, films, scenes }) {
  if (stills.length + films.length + scenes.length === 0) return [];
  const small = (id) => [`${id}.width=96`, `${id}.height=54`, `${id}.samples=1`];
  const short = (id) => [`${id}.from=1`, `${id}.to=1.5`, `${id}.fps=4`];
  const sets = [...[...stills, ...films].flatMap(small), ...films.flatMap(short)].flatMap((set) => ['--set', set]);
  const backend = ['--pipeline', 'raster', '--backend', 'webgpu'];
  return [job('webgpu', name, 'files of its nodes', [['render', file, ...backend, ...sets, '--json']])];
}

/** Every integration method for a short time, on the GPU, and resumed from a checkpoint. */
function methodJobs(projects) {
  const cloth = projects.find(({ name }) => name === 'hanging-cloth');
  if (!cloth) return [];
  const line = (duration, ...more) => [
    ...['simulate', cloth.file, '--csv', 'energy.csv', '--set', `swing.duration=${duration}`, ...more, '--json'],
  ];
  const set = (text) => ['--set', `swing.${text}`];
  const kept = ['--checkpoint', 'cloth.run'];
  return [
    ...METHODS.map((method) =>
      job('simulate', 'hanging-cloth', method, [line(0.1, ...set(`method=${method}`), ...set('step=0.001'))]),
    ),
    job('simulate', 'hanging-cloth', 'corrected', [
      line(0.1, ...set('method=linearly-implicit'), ...set('correction=2'), ...set('step=0.001')),
    ]),
    job('simulate', 'hanging-cloth', 'newton', [line(0.2, ...set('mechanics=newton'))]),
    job('simulate', 'hanging-cloth', 'adaptive', [line(0.2, ...set('tolerance=0.001'))]),
    job('simulate', 'hanging-cloth', 'on the GPU', [line(0.2, ...set('onGpu=on'), '-o', 'cloth.usda')]),
    job('simulate', 'hanging-cloth', 'checkpoint', [
      line(0.25, ...kept),
      line(0.5, ...kept, '--resume', '-o', 'cloth.glb'),
    ]),
  ];
}

/** Usage errors: exit codes are compared, messages reported. */
function usageJobs(scenes, others) {
  const street = scenes.find(({ name }) => name === 'street')?.file ?? 'none.usda';
  const tooFast = others.find(({ name }) => name === 'too-fast.usda')?.file ?? 'none.usda';
  const lines = [
    ['render', street, '-o', 'a.bmp'],
    ['render', street, '-o', 'a.png', '--aov', 'depth'],
    ['render', street, '-o', 'a.png', '--pipeline', 'reference', '--backend', 'webgpu'],
    ['render', street, '-o', 'a.png', '--beta', '1,0,0'],
    ['render', street, '-o', 'a.png', '--pipeline', 'raster', '--bounces', '2'],
    ['render', 'none.usda', '-o', 'a.png', '--pipeline', 'reference'],
    ['render', tooFast, '-o', 'a.png', '--pipeline', 'reference'],
    ['probe', street, '--prim', '/World/None'],
    ['probe', street],
    ['convert', street, 'a.fbx'],
    ['simulate', street, '--csv', 'a.csv'],
    ['inspect', tooFast, '--json'],
    ['compare', street, street],
  ];
  return [job('usage', 'program', 'refusals', lines)];
}

/** One process each: the help of a subcommand ends the process. */
function helpJobs() {
  const lines = [
    ...COMMANDS.map((command) => [command, '--help'].filter(Boolean)),
    ...GRAPH_COMMANDS.map((command) => ['graph', command, '--help']),
    ['graph', 'docs'],
    ['--version'],
  ];
  return lines.map((line) => job('help', 'program', line.join(' '), [line], { batch: line.join(' ') }));
}
