import type { ParamValue } from '../../src/graph/document/document.ts';
import { build } from './buildProject.ts';
import { farCorners } from './hangingCloth.ts';
import { type NodeSketches, withMaterial } from './simulationScene.ts';

/* The experiments of the source documents (docs/physics.md §14) as they are: a kilogram of cloth with springs of 1000 N/m, held at two corners
   and released level, weight 9.8 m/s², steps of 1 ms. They do not say how large it is: here 2 m and 20 × 20 points, without springs
   against bending, as in the assignment that they refer to; its duration, the place of the ball and the cameras are ours. They name a damping of
   0.995 without saying what it multiplies; it would hide what the methods do, and is left out. */

const SIDE = 2;
const CELLS = 19;
const STEP = 0.001;
/** The speed of light of the picture [m/s]: far above that of the experiments, which are seen as they are. */
const SEEN_AT = 1000;
/** Distance between cloths [m]. */
const [ACROSS, DOWN] = [3.4, 2.6];

/** The sources' families, each with its name, and colours of the columns. */
const FAMILIES = [
  ['semi-implicit-euler', 'Semi-implicit', [0.8, 0.25, 0.06]],
  ['linearly-implicit', 'Linearly implicit', [0.75, 0.6, 0.1]],
  ['local-global', 'Local–global', [0.15, 0.5, 0.2]],
] as const;
const OURS_COLOR = [0.1, 0.25, 0.7] as const;
type Color = readonly [number, number, number];

/** One run. */
interface Run {
  readonly name: string;
  /** Column from the left and row from the top. */
  readonly at: readonly [column: number, row: number];
  readonly color: Color;
  readonly set: Readonly<Record<string, ParamValue>>;
  readonly matter: readonly string[];
}

/** The cloth as matter, and its weight. */
const cloth = (above: number): NodeSketches => ({
  sheet: { type: 'grid', set: { name: 'Cloth', width: SIDE, length: SIDE, columns: CELLS, rows: CELLS } },
  hung: {
    type: 'transform',
    set: { position: [0, above, 0], rotation: [0, 180, 0] },
    from: { geometry: 'sheet.geometry' },
  },
  net: {
    type: 'mass-spring',
    set: { structural: 1000, shear: 1000, bending: 0, pins: 'points', pinned: farCorners(SIDE, CELLS) },
    from: { geometry: 'hung.geometry' },
  },
  weight: { type: 'field', set: { gravity: [0, -9.8, 0] } },
  span: { type: 'number', set: { number: 2.5 } },
});

/** Simulates and places each run; its cloth has the colour of its column. Outputs: `NAMEAt.geometry`. */
const runs = (all: readonly Run[]): NodeSketches =>
  Object.fromEntries(
    all.flatMap(({ name, at: [column, row], color, set, matter }) => [
      [
        name,
        {
          type: 'simulate',
          set: { rate: 48, step: STEP, ...set, ...(set.method === 'semi-implicit-euler' && { evenUnstable: true }) },
          from: { matter, duration: 'span.number' },
        },
      ],
      [`${name}Colour`, withMaterial(`${name}.geometry`, color, { which: '/Cloth', roughness: 0.6 })],
      [
        `${name}At`,
        {
          type: 'transform',
          set: { position: [ACROSS * column, -DOWN * row, 0] },
          from: { geometry: `${name}Colour.geometry` },
        },
      ],
    ]),
  );

/** A word in front of a column or row. */
const word = (name: string, text: string, position: readonly [number, number, number]): NodeSketches => ({
  [name]: { type: 'solid-text', set: { name, text, size: 0.3, depth: 0.03 } },
  [`${name}At`]: { type: 'transform', set: { position }, from: { geometry: `${name}.geometry` } },
});

/** What all experiments share: light, camera, the picture, and the film that `slowlight render PROJECT` writes. */
const shown = (
  things: { readonly runs: readonly string[]; readonly words: readonly string[] },
  film: string,
  { eye, target, fieldOfView }: { eye: Color; target: Color; fieldOfView: number },
): NodeSketches => ({
  words: { type: 'merge', from: { geometry: things.words.map((name) => `${name}At.geometry`) } },
  ink: withMaterial('words.geometry', [0.03, 0.03, 0.04]),
  cloths: { type: 'merge', from: { geometry: things.runs.map((name) => `${name}At.geometry`) } },
  eye: { type: 'camera', set: { name: 'Eye', position: eye, target, fieldOfView } },
  sun: { type: 'sun', set: { brightness: 2.4, direction: [-0.4, -0.5, -0.8] } },
  sky: { type: 'sky', set: { color: [0.55, 0.6, 0.68], brightness: 0.7 } },
  time: { type: 'time', set: { from: 0, openAt: 1 }, from: { to: 'span.number' } },
  scene: {
    type: 'scene',
    from: {
      geometry: ['eye.geometry', 'ink.geometry', 'cloths.geometry'],
      lights: ['sun.lights', 'sky.lights'],
      time: 'time.time',
    },
  },
  console: { type: 'relativity-console', set: { speedOfLight: SEEN_AT }, from: { scene: 'scene.scene' } },
  camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
  rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
  lighting: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
  toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
  film: {
    type: 'save-video',
    set: { name: `${film}.gif`, width: 640, height: 360, from: 0, fps: 20 },
    from: { image: 'toneMap.image', to: 'span.number' },
  },
  output: { type: 'output', from: { image: 'film.image' } },
});

const CORRECTIONS = ['none', 'tangent', 'secant', 'root'];
const OURS = ['discrete-gradient', 'implicit-midpoint', 'leapfrog', 'yoshida-4'];

/** All methods and corrections at 10 m/s, beside ours. */
export const sourceCorrections = () => {
  const c = 10;
  const theirs = FAMILIES.flatMap(([method, , color], column) =>
    CORRECTIONS.map(
      (_, row): Run => ({
        name: `run${column}${row}`,
        at: [column, row],
        color,
        set: { speedOfLight: c, method, correction: String(row) },
        matter: ['net.matter', 'weight.matter'],
      }),
    ),
  );
  const ours = OURS.map(
    (method, row): Run => ({
      name: `run3${row}`,
      at: [3, row],
      color: OURS_COLOR,
      // Explicit methods need half of the step here.
      set: { speedOfLight: c, method, step: STEP / 2 },
      matter: ['net.matter', 'weight.matter'],
    }),
  );
  const all = [...theirs, ...ours];
  const names = [...FAMILIES.map(([, title]) => title), 'Ours'];
  const titles = names.map((text, column) => [`Column${column}`, text, [ACROSS * column, 1.6, -1]] as const);
  const rows = CORRECTIONS.map((text, row) => [`Row${row}`, text, [-2.6, -DOWN * row + 0.5, -1]] as const);
  return build(
    {
      title: 'The sources’ methods and corrections',
      lookFor:
        'The cloth of the documents that this program began with, by their methods, c = 10 m/s, steps of 1 ms. Rows: without energy correction, by the tangent, the secant, the root. Semi-implicit cloths shiver and burst; implicit ones fade, as if in honey, and the secant does nothing about it; the root conserves the energy. In blue, ours at half the step. Amber nodes say what went wrong; the energy panel shows it.',
    },
    {
      ...cloth(1),
      ...runs(all),
      ...Object.assign({}, ...[...titles, ...rows].map(([name, text, at]) => word(name, text, at))),
      ...shown(
        { runs: all.map(({ name }) => name), words: [...titles, ...rows].map(([name]) => name) },
        'source-corrections',
        { eye: [4.1, -3.2, 17.5], target: [4.1, -3.7, 0], fieldOfView: 40 },
      ),
    },
  );
};

const SECANT = { correction: '2' } as const;
const EXACT = { method: 'discrete-gradient' } as const;
/** The sources' methods with the correction that they recommend, and ours: name, colour, parameters. */
const RECOMMENDED = [
  ...FAMILIES.map(([method, title, color]) => ({ title, color, set: { method, ...SECANT } })),
  { title: 'Ours', color: OURS_COLOR, set: EXACT },
];
const SPEEDS = [1, 10, 100];

/** The recommended methods and ours in columns, a row for each speed of light [m/s]. `more`: what the cloth meets, and the name of its matter. */
function bySpeed(about: Parameters<typeof build>[0], film: string, more: NodeSketches, met: readonly string[]) {
  const all = RECOMMENDED.flatMap(({ color, set }, column) =>
    SPEEDS.map(
      (speedOfLight, row): Run => ({
        name: `run${column}${row}`,
        at: [column, row],
        color,
        set: { speedOfLight, ...set },
        matter: ['net.matter', ...met, 'weight.matter'],
      }),
    ),
  );
  const words = [
    ...RECOMMENDED.map(({ title }, column) => [`Column${column}`, title, [ACROSS * column, 1.6, -1]] as const),
    ...SPEEDS.map((c, row) => [`Row${row}`, `c = ${c} m/s`, [-3.2, -DOWN * row + 0.4, -1]] as const),
  ];
  return build(about, {
    ...cloth(1),
    ...more,
    ...runs(all),
    ...Object.assign({}, ...words.map(([name, text, at]) => word(name, text, at))),
    ...shown({ runs: all.map(({ name }) => name), words: words.map(([name]) => name) }, film, {
      ...{ eye: [4.2, -1.7, 16.5], target: [4.2, -2.4, 0], fieldOfView: 40 },
    }),
  });
}

/** The cloth with the recommended correction at 1, 10 and 100 m/s, beside ours. */
export const sourceSpeeds = () =>
  bySpeed(
    {
      title: 'The sources’ methods at c = 1, 10, 100',
      lookFor:
        'The same cloth where nothing exceeds 1, 10 and 100 m/s, by the methods of the documents with the secant that they recommend, and in blue by ours, which conserves the energy. At 1 m/s the cloth falls slowly. Semi-implicit cloths burst, and stay as they were when their run ended: their nodes are amber and say when and why. Every Simulate node has its method, correction, step and speed of light: change them.',
    },
    'source-speeds',
    {},
    [],
  );

/** Cloth and ball at 1, 10 and 100 m/s, by the recommended methods and ours. */
export const sourceBall = () =>
  bySpeed(
    {
      title: 'The sources’ cloth and ball at c = 1, 10, 100',
      lookFor:
        'The cloth of the documents swings against a ball of 40 cm that pushes by 10⁴ N/m, where nothing exceeds 1, 10 and 100 m/s, steps of 1 ms: by their methods with the secant, and in blue by ours. Implicit cloths lose energy with every step, as in their films; semi-implicit ones burst at the ball and stay as they were then. Save Video, or “slowlight render” with the project alone, makes a film of it as a GIF.',
    },
    'source-ball',
    {
      round: { type: 'sphere', set: { name: 'Ball', radius: 0.4, segments: 48, rings: 24 } },
      ivory: withMaterial('round.geometry', [0.8, 0.78, 0.7], { roughness: 0.4 }),
      below: { type: 'transform', set: { position: [0, 0.2, 0] }, from: { geometry: 'ivory.geometry' } },
      ball: {
        type: 'collider',
        set: { shape: 'ball', scale: 1.1, stiffness: 10_000 },
        from: { geometry: 'below.geometry' },
      },
    },
    ['ball.matter'],
  );
