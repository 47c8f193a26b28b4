import { Command } from 'commander';
import { degrees } from '../../math/angle.ts';
import { fastestVertex, pointSamples, sampleTimes } from '../../scene/motion/motion.ts';
import type { Diagnostic, Scene, SceneObject, VariantSet } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import { addSceneFlags, openSceneWithFlags, SCENE_ARGUMENT, type SceneFlags } from '../flags/sceneFlags.ts';
import { speedOfLight, speedOfLightOption } from '../flags/viewFlags.ts';
import { CliError, EXIT } from '../terminal/exitCodes.ts';
import { treeLines } from './tree.ts';

export const inspectCommand = (): Command =>
  addSceneFlags(
    new Command('inspect')
      .description('Reports the contents of a scene file, its speeds, and its errors.')
      .argument('<file>', SCENE_ARGUMENT),
  )
    .addOption(speedOfLightOption())
    .option('--json', 'print as JSON')
    .action(inspect);

async function inspect(path: string, flags: SceneFlags & { c?: number; json?: boolean }): Promise<void> {
  const scene = await openSceneWithFlags(path, flags);
  const summary = summarize(scene, speedOfLight(scene, flags.c));
  console.log(flags.json ? JSON.stringify(summary, null, 2) : describe(summary));
  const errors = summary.diagnostics.filter(({ severity }) => severity === 'error').length;
  if (errors > 0)
    throw new CliError(EXIT.input, `${path}: ${errors === 1 ? 'an error' : `${errors} errors`}, told above`);
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
    lights: scene.lights.map(({ kind, path }) => ({ kind, path })),
    cameras: scene.cameras.map(({ path, motion, fovY }) => ({
      path,
      motion: motion.kind,
      fov: degrees(fovY),
    })),
    diagnostics: [...scene.diagnostics, ...validate(scene, c)],
  };
}

function summarizeObject({ path, mesh, motion, lifetime, authoredIn }: SceneObject) {
  const points = pointSamples(motion);
  return {
    path,
    vertices: mesh.positions.length / 3,
    triangles: mesh.indices.length / 3,
    motion: motion.kind,
    samples: sampleTimes(motion)?.length ?? 0,
    ...(points && { interpolation: points.velocities ? 'cubic' : 'linear' }),
    authoredIn,
    // Infinite bounds are omitted: JSON has no infinity.
    birth: Number.isFinite(lifetime.birth) ? lifetime.birth : undefined,
    death: Number.isFinite(lifetime.death) ? lifetime.death : undefined,
  };
}

/** The fastest point of the scene; undefined if nothing moves. */
function fastestPoint(scene: Scene, c: number) {
  let best:
    | { path: string; vertex: number; speed: number; fractionOfC: number; from?: number; to?: number }
    | undefined;
  for (const object of scene.objects) {
    const { speed, vertex, from, to } = fastestVertex(object, c, [scene.startTime, scene.endTime], best?.speed);
    if (!(speed > (best?.speed ?? 0))) continue;
    // Uniform motion has its speed at all times: no interval, and JSON has no infinity.
    const when = Number.isFinite(from) ? { from, to } : {};
    best = { path: object.path, vertex, speed, fractionOfC: speed / c, ...when };
  }
  return best;
}

function describe(s: Summary): string {
  const { counts: n } = s;
  const parts = [
    s.title ? `${s.name} – ${s.title}` : s.name,
    ...(s.lookFor ? [`  ${s.lookFor}`] : []),
    `  ${s.upAxis} up, 1 unit = ${s.metersPerUnit} m, ${s.timeCodesPerSecond} time codes a second, ${s.startTime} … ${s.endTime} s`,
    `  ${count(n.objects, 'object')}, ${count(n.vertices, 'vertex', 'vertices')}, ${count(n.triangles, 'triangle')}, ${count(n.materials, 'material')}, ${count(n.lights, 'light')}, ${count(n.cameras, 'camera')}`,
    s.fastest
      ? `  fastest: ${s.fastest.path}, ${s.fastest.speed.toPrecision(6)} m/s = ${s.fastest.fractionOfC.toPrecision(6)} c${period(s.fastest)} (c = ${s.speedOfLight} m/s)`
      : `  nothing moves (c = ${s.speedOfLight} m/s)`,
    ...(s.pathError === undefined ? [] : [`  paths between samples are ${describePathError(s.pathError)}`]),
    ...s.variants.map(variantLine),
    '',
    ...treeLines(treeEntries(s)),
    ...(s.diagnostics.length > 0 ? ['', ...s.diagnostics.map(diagnosticLine)] : []),
  ];
  return parts.join('\n');
}

/** Below 1 nm the error is rounding. */
const describePathError = (error: number): string => (error < 1e-9 ? 'exact' : `right to ${error.toPrecision(2)} m`);
const variantLine = ({ set, options, chosen }: VariantSet): string =>
  `  ${set}: ${options.map((option) => (option === chosen ? `[${option}]` : option)).join(', ')}`;

const period = ({ from, to }: { from?: number; to?: number }): string =>
  from === undefined ? '' : from === to ? ` at ${from} s` : ` from ${from} to ${to} s`;
const count = (n: number, one: string, many = `${one}s`): string => `${n.toLocaleString('en')} ${n === 1 ? one : many}`;
const diagnosticLine = ({ severity, place, message }: Diagnostic): string => `${severity}: ${place}: ${message}`;

function treeEntries(s: Summary): { path: string; note: string }[] {
  const objects = s.objects.map((o) => {
    const motion =
      o.samples > 0
        ? `${o.motion}${o.interpolation === 'cubic' ? ' along cubics' : ''}, ${count(o.samples, 'sample')}`
        : o.motion;
    const rest = o.authoredIn === 'rest' ? ', authored at rest' : '';
    const life =
      o.birth !== undefined || o.death !== undefined ? `, lives ${o.birth ?? '−∞'} … ${o.death ?? '∞'} s` : '';
    return { path: o.path, note: `${count(o.triangles, 'triangle')}, ${motion}${rest}${life}` };
  });
  const lights = s.lights.map(({ path, kind }) => ({ path, note: `${kind} light` }));
  const cameras = s.cameras.map(({ path, motion, fov }) => ({
    path,
    note: `camera, ${motion}, ${fov.toFixed(1)}° high`,
  }));
  return [...objects, ...lights, ...cameras];
}
