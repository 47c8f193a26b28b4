import { degrees } from '../../math/angle.ts';
import { inLines, type LocalizedText, listed, type Message, msg } from '../../messages/message.ts';
import type { Light } from '../../scene/lights/light.ts';
import { fastestVertex, pointSamples, sampleTimes } from '../../scene/motion/motion.ts';
import type { Lifetime, Motion } from '../../scene/motion/motionTypes.ts';
import type { Material, Scene, SceneObject, Texture, VariantSet } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import { openSceneWithFlags } from '../flags/openScene.ts';
import { speedOfLight } from '../flags/viewFlags.ts';
import { diagnosticLine } from '../terminal/diagnostics.ts';
import { inputProblem } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { localized } from '../terminal/language.ts';
import type { InspectFlags } from './inspectFlags.ts';
import { treeLines } from './tree.ts';

export async function inspect(path: string, flags: InspectFlags): Promise<void> {
  const scene = await openSceneWithFlags(path, flags);
  const summary = summarize(scene, speedOfLight(scene, flags.c));
  console.log(flags.json ? toJson(summary) : describe(summary));
  const errors = summary.diagnostics.filter(({ severity }) => severity === 'error').length;
  if (errors > 0)
    throw inputProblem(errors === 1 ? msg`${path}: an error, told above` : msg`${path}: ${errors} errors, told above`);
}

type Summary = ReturnType<typeof summarize>;

function summarize(scene: Scene, c: number) {
  const objects = scene.objects.map(summarizeObject);
  const total = (key: 'vertices' | 'triangles'): number => objects.reduce((sum, object) => sum + object[key], 0);
  return {
    name: scene.name,
    title: scene.hints.title,
    lookFor: scene.hints.lookFor,
    upAxis: scene.upAxis,
    metersPerUnit: scene.metersPerUnit,
    timeCodesPerSecond: scene.timeCodesPerSecond,
    startTime: scene.startTime,
    endTime: scene.endTime,
    speedOfLight: c,
    counts: {
      objects: objects.length,
      vertices: total('vertices'),
      triangles: total('triangles'),
      materials: scene.materials.length,
      lights: scene.lights.length,
      cameras: scene.cameras.length,
    },
    fastest: fastestPoint(scene, c),
    pathError: Number.isFinite(scene.pathError) ? scene.pathError : undefined,
    variants: scene.variants ?? [],
    objects,
    materials: scene.materials.map(summarizeMaterial),
    lights: scene.lights.map((light) => ({
      ...('film' in light && { filmFrames: light.film?.track.times.length }),
      kind: light.kind,
      path: light.path,
      ...('lifetime' in light && lifeOf(light.lifetime)),
    })),
    cameras: scene.cameras.map(({ path, motion, fovY }) => ({
      path,
      motion: motion.kind,
      fov: degrees(fovY),
    })),
    diagnostics: [...scene.diagnostics, ...validate(scene, c)],
  };
}

function summarizeObject({ path, mesh, motion, lifetime, authoredIn, pieceOf }: SceneObject) {
  const points = pointSamples(motion);
  return {
    path,
    vertices: mesh.positions.length / 3,
    triangles: mesh.indices.length / 3,
    motion: motion.kind,
    samples: sampleTimes(motion)?.length ?? 0,
    ...(points && { interpolation: points.velocities ? 'cubic' : 'linear' }),
    authoredIn,
    ...lifeOf(lifetime),
    pieceOf,
  };
}

/** A material without the texels of its textures. */
function summarizeMaterial(material: Material): Record<string, unknown> {
  const plain = (value: unknown): unknown => {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) return value;
    if ('data' in value && 'width' in value) {
      const { name, width, height } = value as Texture;
      return { name, width, height };
    }
    return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, plain(part)]));
  };
  const { reflectance, ...rest } = material;
  return { ...(plain(rest) as Record<string, unknown>), ...(reflectance && { reflectance: true }) };
}

/** Infinite bounds are omitted: JSON has no infinity. */
const lifeOf = ({ birth, death }: Lifetime) => ({
  birth: Number.isFinite(birth) ? birth : undefined,
  death: Number.isFinite(death) ? death : undefined,
});

/** The fastest point of the scene; undefined if nothing moves. */
function fastestPoint(scene: Scene, c: number) {
  let best:
    | { path: string; vertex: number; speed: number; fractionOfC: number; from?: number; to?: number }
    | undefined;
  for (const object of scene.objects) {
    const { speed, vertex, from, to } = fastestVertex(object, c, [scene.startTime, scene.endTime], best?.speed);
    if (!(speed > (best?.speed ?? 0))) continue;
    // Uniform motion has its speed at all times: no interval, and JSON has no infinity.
    const { birth, death } = object.lifetime;
    const when = Number.isFinite(from) ? { from: Math.max(from, birth), to: Math.min(to, death) } : {};
    best = { path: object.path, vertex, speed, fractionOfC: speed / c, ...when };
  }
  return best;
}

function describe(s: Summary): string {
  // Missing files that a line sums up are listed one by one in JSON only.
  const told = s.diagnostics.filter(({ severity, missing }) => severity !== 'info' || !missing);
  const parts = [
    s.title ? `${s.name} – ${s.title}` : s.name,
    ...[...(s.lookFor ? [s.lookFor] : []), ...summaryLines(s)].map((line) => msg`  ${line}`),
    '',
    ...treeLines(treeEntries(s)),
    ...(told.length > 0 ? ['', ...told.map(diagnosticLine)] : []),
  ];
  return localized(inLines(parts));
}

const summaryLines = (s: Summary): readonly LocalizedText[] => [
  msg`${s.upAxis} up, 1 unit = ${s.metersPerUnit} m, ${s.timeCodesPerSecond} time codes a second, ${s.startTime} … ${s.endTime} s`,
  listed(Object.entries(s.counts).map(([what, n]) => counted(n, COUNTED[what as keyof typeof COUNTED]))),
  s.fastest
    ? msg`fastest: ${s.fastest.path}, ${s.fastest.speed.toPrecision(6)} m/s = ${s.fastest.fractionOfC.toPrecision(6)} c${period(s.fastest)} (c = ${s.speedOfLight} m/s)`
    : msg`nothing moves (c = ${s.speedOfLight} m/s)`,
  ...(s.pathError === undefined ? [] : [pathErrorLine(s.pathError)]),
  ...s.variants.map(variantLine),
  ...layerLines(s),
];

/** The materials that have more than a base. */
function layerLines({ materials }: Summary): readonly LocalizedText[] {
  return EXTRAS.flatMap(([field, what]) => {
    const names = materials.flatMap((m) => (m[field] !== undefined ? [String(m.name)] : []));
    const more = names.length > 5 ? [msg`${names.length - 5} more`] : [];
    return names.length > 0 ? [msg`${what}: ${listed([...names.slice(0, 5), ...more])}`] : [];
  });
}

const EXTRAS: readonly (readonly [keyof Material, Message])[] = [
  ['unlit', msg`unlit`],
  ['specular', msg`strength or colour of reflection`],
  ['clearcoat', msg`clearcoat`],
  ['anisotropy', msg`anisotropy`],
  ['sheen', msg`sheen`],
  ['transmission', msg`transmission`],
  ['iridescence', msg`iridescence`],
];

/** Below 1 nm the error is rounding. */
const pathErrorLine = (error: number): Message =>
  error < 1e-9
    ? msg`paths between samples are exact`
    : msg`paths between samples are right to ${error.toPrecision(2)} m`;
const variantLine = ({ set, options, chosen }: VariantSet): Message =>
  msg`${set}: ${listed(options.map((option) => (option === chosen ? `[${option}]` : option)))}`;

const period = ({ from, to }: { from?: number; to?: number }): LocalizedText => {
  if (from === undefined || to === undefined) return '';
  return from === to ? msg` at ${from} s` : msg` from ${from} to ${to} s`;
};

/** Of one, and of several. */
const COUNTED = {
  objects: [msg`1 object`, (n: string) => msg`${n} objects`],
  vertices: [msg`1 vertex`, (n: string) => msg`${n} vertices`],
  triangles: [msg`1 triangle`, (n: string) => msg`${n} triangles`],
  materials: [msg`1 material`, (n: string) => msg`${n} materials`],
  lights: [msg`1 light`, (n: string) => msg`${n} lights`],
  cameras: [msg`1 camera`, (n: string) => msg`${n} cameras`],
  samples: [msg`1 sample`, (n: string) => msg`${n} samples`],
} as const;

const counted = (n: number, [one, several]: (typeof COUNTED)[keyof typeof COUNTED]): Message =>
  n === 1 ? one : several(n.toLocaleString('en'));

const MOTIONS: Readonly<Record<Motion['kind'], Message>> = {
  static: msg`static`,
  uniform: msg`uniform`,
  hyperbolic: msg`hyperbolic`,
  sampled: msg`sampled`,
  'sampled-points': msg`sampled-points`,
};

const LIGHTS: Readonly<Record<Light['kind'], Message>> = {
  distant: msg`distant light`,
  sphere: msg`sphere light`,
  rect: msg`rect light`,
  disk: msg`disk light`,
  cylinder: msg`cylinder light`,
  dome: msg`dome light`,
  stars: msg`stars light`,
};

/** Pieces of one thing that are listed; of others only the number. */
const LISTED_PIECES = 6;

function treeEntries(s: Summary): { path: string; note: string }[] {
  const pieces = new Map<string, number>();
  for (const { pieceOf } of s.objects) if (pieceOf !== undefined) pieces.set(pieceOf, (pieces.get(pieceOf) ?? 0) + 1);
  const isListed = lister(pieces);
  const objects = s.objects.filter(isListed).map(({ path, ...o }) => {
    const motion = o.interpolation === 'cubic' ? msg`${MOTIONS[o.motion]} along cubics` : MOTIONS[o.motion];
    const facts = [
      counted(o.triangles, COUNTED.triangles),
      ...(o.samples > 0 ? [motion, counted(o.samples, COUNTED.samples)] : [MOTIONS[o.motion]]),
      ...(o.authoredIn === 'rest' ? [msg`authored at rest`] : []),
      ...lifeFact(o),
    ];
    return { path, note: localized(listed(facts)) };
  });
  const wholes = [...pieces].map(([path, n]) => ({ path, note: localized(piecesNote(n)) }));
  const lights = s.lights.map(({ path, kind, filmFrames, ...life }) => ({
    path,
    note: localized(
      listed([LIGHTS[kind], ...(filmFrames ? [msg`a film of ${filmFrames} frames`] : []), ...lifeFact(life)]),
    ),
  }));
  const cameras = s.cameras.map(({ path, motion, fov }) => ({
    path,
    note: localized(msg`camera, ${MOTIONS[motion]}, ${fov.toFixed(1)}° high`),
  }));
  return [...wholes, ...objects, ...lights, ...cameras];
}

const lifeFact = ({ birth, death }: { readonly birth?: number; readonly death?: number }): readonly Message[] =>
  birth !== undefined || death !== undefined ? [msg`lives ${rounded(birth) ?? '−∞'} … ${rounded(death) ?? '∞'} s`] : [];

const rounded = (t: number | undefined): number | undefined => (t === undefined ? t : Number(t.toPrecision(6)));

const piecesNote = (n: number): Message =>
  n > LISTED_PIECES
    ? msg`${n} pieces that take turns, of which the first ${LISTED_PIECES} are listed`
    : msg`${n} pieces that take turns`;

/** Accepts wholes, and the first pieces of each thing. */
function lister(pieces: ReadonlyMap<string, number>): (object: { readonly pieceOf?: string | undefined }) => boolean {
  const left = new Map([...pieces.keys()].map((path) => [path, LISTED_PIECES]));
  return ({ pieceOf }) => {
    if (pieceOf === undefined) return true;
    const n = left.get(pieceOf) ?? 0;
    left.set(pieceOf, n - 1);
    return n > 0;
  };
}
