import { length, type Vec3 } from '../../math/vec3.ts';
import { type LocalizedText, listed, type Message, msg } from '../../messages/message.ts';
import { gamma, velocity } from '../../physics/lorentz/boost.ts';
import { inspectEvent } from '../../scene/inspection/inspectEvent.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import { probeVertices, type VertexProbe } from '../../scene/view/probe.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { observerPath } from '../flags/observerPath.ts';
import { openSceneWithFlags } from '../flags/openScene.ts';
import { speedOfLight } from '../flags/viewFlags.ts';
import { reportDiagnostics } from '../terminal/diagnostics.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { localized } from '../terminal/language.ts';
import { probePixel } from './pixelProbe.ts';
import type { ProbeFlags } from './probeFlags.ts';

export async function probe(path: string, flags: ProbeFlags): Promise<void> {
  if ((flags.prim === undefined) === (flags.pixel === undefined)) throw usageError(msg`give either --prim or --pixel`);
  const { view: name, coneSlope, solver, iterations, damping } = flags;
  const newton = solver === 'newton' ? { iterations, damping } : undefined;
  const how = { newton, coneSlope };
  if (newton && flags.pixel)
    throw usageError(msg`--solver newton is for --prim: a pixel is probed by a ray, which needs no solver`);
  const scene = await openSceneWithFlags(path, flags);
  const c = speedOfLight(scene, flags.c);
  reportDiagnostics([...scene.diagnostics, ...validate(scene, c)]);
  const t = flags.time ?? scene.hints.openAt ?? scene.startTime;
  const view = observerPath(scene, flags, c, t)(t);
  const about = {
    scene: scene.name,
    time: t,
    speedOfLight: c,
    view: name,
    ...(name === 'slice-to-cone' && { coneSlope }),
    observer: describeObserver(view),
  };
  if (flags.pixel) {
    const observed = probePixel(scene, view, c, { view: name, coneSlope }, flags.size, flags.pixel);
    const inspected = observed && inspectEvent(scene.objects[observed.object - 1]!, observed, view, c);
    const { pixel, size } = flags;
    return print(flags, { ...about, pixel, size, seen: observed ?? null, inspection: inspected ?? null });
  }
  const seenVertices = (piece: SceneObject): number =>
    probeVertices(piece, view, c, name, how).filter((event) => event?.visible).length;
  const object = findObject(scene, flags.prim ?? '', seenVertices);
  const probed = probeVertices(object, view, c, name, how);
  const vertices = probed.map((event, i) => event ?? { vertex: i, visible: false });
  if (flags.json) print(flags, { ...about, prim: object.path, vertices });
  else printTable(probed);
}

const describeObserver = ({ t, position, u }: ViewPoint) => ({
  time: t,
  position,
  beta: velocity(u),
  speed: length(velocity(u)),
  gamma: gamma(u),
});

/** The object at a path; of a thing whose pieces take turns the piece of which most is seen. */
function findObject(scene: Scene, path: string, seenVertices: (piece: SceneObject) => number): SceneObject {
  const object = scene.objects.find((candidate) => candidate.path === path);
  if (object) return object;
  const pieces = scene.objects
    .filter(({ pieceOf }) => pieceOf === path)
    .map((piece) => ({ piece, n: seenVertices(piece) }));
  const [most] = pieces.sort((a, b) => b.n - a.n);
  if (most) return most.piece;
  const near = scene.objects.filter((candidate) => candidate.path.includes(path)).slice(0, 8);
  const known = listed((near.length > 0 ? near : scene.objects.slice(0, 8)).map((candidate) => candidate.path));
  throw usageError(msg`--prim ${path}: the scene has no such object; it has ${known || msg`none`}`);
}

/** What is printed for people of names that JSON has. */
const LABELS: Readonly<Record<string, Message>> = {
  scene: msg`scene`,
  time: msg`time`,
  speedOfLight: msg`speedOfLight`,
  view: msg`view`,
  coneSlope: msg`coneSlope`,
  observer: msg`observer`,
  position: msg`position`,
  beta: msg`beta`,
  speed: msg`speed`,
  gamma: msg`gamma`,
  pixel: msg`pixel`,
  size: msg`size`,
  width: msg`width`,
  height: msg`height`,
  seen: msg`seen`,
  prim: msg`prim`,
  object: msg`object`,
  velocity: msg`velocity`,
  apparent: msg`apparent`,
  distance: msg`distance`,
  doppler: msg`doppler`,
  normal: msg`normal`,
  albedo: msg`albedo`,
  occlusion: msg`occlusion`,
  inspection: msg`inspection`,
  emissionTime: msg`emissionTime`,
  emissionPosition: msg`emissionPosition`,
  properTime: msg`properTime`,
  distanceThen: msg`distanceThen`,
  distanceNow: msg`distanceNow`,
  relativeVelocity: msg`relativeVelocity`,
  apparentSpeedAcross: msg`apparentSpeedAcross`,
  apparentRadialSpeed: msg`apparentRadialSpeed`,
  superluminal: msg`superluminal`,
  rotation: msg`rotation`,
};

/** Prints `name value` lines or JSON. */
function print(flags: ProbeFlags, result: object): void {
  const lines = (value: object, indent: string): string[] =>
    Object.entries(value).flatMap(([key, entry]) => {
      const label = `${indent}${localized(LABELS[key] ?? key)}`;
      if (entry !== null && typeof entry === 'object' && !Array.isArray(entry))
        return [label, ...lines(entry, `${indent}  `)];
      return [`${label}  ${Array.isArray(entry) ? entry.join(' ') : String(entry ?? localized(msg`nothing`))}`];
    });
  console.log(flags.json ? toJson(result) : lines(result, '').join('\n'));
}

function printTable(probed: readonly (VertexProbe | undefined)[]): void {
  const print = (cells: readonly LocalizedText[]): void => console.log(cells.map(localized).join('\t'));
  print([msg`vertex`, msg`time [s]`, msg`apparent x`, 'y', 'z [m]', msg`distance [m]`, 'D', msg`visible`]);
  const numbers = (v: Vec3): string[] => v.map((x) => x.toPrecision(9));
  probed.forEach((event, i) => {
    const cells = event
      ? [
          event.time.toPrecision(12),
          ...numbers(event.apparent),
          event.distance.toPrecision(9),
          event.doppler.toPrecision(9),
          event.visible ? msg`true` : msg`false`,
        ]
      : [msg`behind a horizon: no light of it ever comes here`];
    print([String(i), ...cells]);
  });
}
