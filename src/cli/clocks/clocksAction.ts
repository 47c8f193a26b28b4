import { seenVelocity } from '../../flight/arc.ts';
import { observerOf } from '../../flight/flightState.ts';
import { length, type Vec3 } from '../../math/vec3.ts';
import { inLines, type LocalizedText, msg } from '../../messages/message.ts';
import { gamma, velocity } from '../../physics/lorentz/boost.ts';
import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import { CLOCK_ABSENCES } from '../../scene/clocks/absences.ts';
import { objectClocks } from '../../scene/clocks/clock.ts';
import {
  type ClockAbsence,
  type ClockObserver,
  type ClockReading,
  type ClockReadings,
  ownReadings,
  readClock,
  worldReadings,
} from '../../scene/clocks/readClock.ts';
import type { Scene } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import { observerPathFrom, observerWorldLine } from '../../scene/view/observerPath.ts';
import { observerSetup } from '../flags/observerPath.ts';
import { speedOfLight } from '../flags/viewFlags.ts';
import { openSceneOrProject, thingsOf } from '../project/sceneOrProject.ts';
import { type FilmedFlight, filmedFlight } from '../render/flightFilm.ts';
import { columns, type Row } from '../terminal/columns.ts';
import { reportDiagnostics } from '../terminal/diagnostics.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { localized } from '../terminal/language.ts';
import type { ClocksFlags } from './clocksFlags.ts';

/** Of one table. */
const MAX_CLOCKS = 2000;

interface NamedReadings {
  readonly name: LocalizedText;
  readonly readings: ClockReadings;
}

export async function clocks(path: string, given: ClocksFlags, names: ReadonlySet<string>): Promise<void> {
  const flight = given.flight === undefined ? undefined : filmedFlight(given.flight, given, names);
  const asked = flight ? { ...given, c: flight.speedOfLight } : given;
  const { scene, flags } = await openSceneOrProject(path, asked, names);
  const c = speedOfLight(scene, flags.c);
  reportDiagnostics([...scene.diagnostics, ...validate(scene, c)]);
  const observer = flight ? pilot(flight, flags.time) : standing(scene, flags, c);
  const objects = objectReadings(scene, flags, observer, c);
  if (flags.json) return console.log(toJson(report(scene, objects, observer, c)));
  console.log(localized(headline(observer, c)));
  console.log(table(objects, observer).join('\n'));
}

/** Who is where the flags say. His clock shows 0 at world time 0: on his camera's path, or as if he had always coasted. */
function standing(scene: Scene, flags: ClocksFlags, c: number): ClockObserver {
  const t = flags.time ?? scene.hints.openAt ?? scene.startTime;
  const setup = observerSetup(scene, flags, c, t);
  const { position, u } = observerPathFrom(setup, c, t)(t);
  const line = observerWorldLine(setup, c);
  return { t, position, u, properTime: line ? properTimeBetween(line, 0, t, c) : t / gamma(u) };
}

/** At full speed, where pictures stop at γ = 10⁴. */
function pilot({ playback }: FilmedFlight, time = playback.duration): ClockObserver {
  if (!(time >= 0 && time <= playback.duration))
    throw usageError(msg`${`--time ${time}`}: the flight lasts from 0 to ${playback.duration} s`);
  const { t, position, u, properTime } = observerOf(playback.stateAt(time));
  const { lock } = playback.legAt(time).conditions;
  return { t, position, u: seenVelocity(lock, u), properTime };
}

function objectReadings(
  scene: Scene,
  { prim }: ClocksFlags,
  observer: ClockObserver,
  c: number,
): readonly NamedReadings[] {
  const found = objectClocks(thingsOf(scene, prim, c), c);
  if (found.length > MAX_CLOCKS)
    throw usageError(msg`${found.length} clocks are too many; choose up to ${MAX_CLOCKS} by --prim`);
  return found.map((clock) => ({ name: clock.path, readings: readClock(clock, observer, c) }));
}

function report(scene: Scene, objects: readonly NamedReadings[], observer: ClockObserver, c: number): object {
  const { t, position, u, properTime } = observer;
  const beta = velocity(u);
  return {
    scene: scene.name,
    speedOfLight: c,
    observer: { time: t, position, beta, speed: length(beta), gamma: gamma(u), properTime },
    ship: readingsInJson(ownReadings(observer)),
    world: readingsInJson(worldReadings(observer)),
    objects: objects.map(({ name, readings }) => ({ prim: name, ...readingsInJson(readings) })),
  };
}

const readingsInJson = ({ seen, slice, world }: ClockReadings): object => ({
  seen: inJson(seen),
  slice: inJson(slice),
  world: inJson(world),
});
const inJson = (shown: ClockReading | ClockAbsence): object => (typeof shown === 'string' ? { absent: shown } : shown);

const headline = ({ t, position, u, properTime }: ClockObserver, c: number): LocalizedText =>
  inLines([
    msg`observer: world time ${digits(t)} s, own clock ${digits(properTime)} s, at ${place(position)} m`,
    msg`β = ${digits(length(velocity(u)))}, γ = ${digits(gamma(u))}, c = ${digits(c)} m/s`,
  ]);

function table(objects: readonly NamedReadings[], observer: ClockObserver): readonly string[] {
  const all = [
    { name: msg`ship`, readings: ownReadings(observer) },
    { name: msg`world`, readings: worldReadings(observer) },
    ...objects,
  ];
  const head: Row = [
    msg`clock [s]`,
    msg`as seen`,
    msg`rate (D)`,
    msg`in the slice`,
    msg`rate`,
    msg`at world time`,
    msg`rate`,
  ];
  const rows = all.map(
    ({ name, readings: { seen, slice, world } }): Row => [name, ...cells(seen), ...cells(slice), ...cells(world)],
  );
  return columns([head, ...rows], 0);
}

const cells = (shown: ClockReading | ClockAbsence): Row =>
  typeof shown === 'string' ? [CLOCK_ABSENCES[shown], '–'] : [digits(shown.properTime), digits(shown.rate)];

const digits = (x: number): string => String(Number(x.toPrecision(9)));
const place = (position: Vec3): string => `(${position.map(digits).join(', ')})`;
