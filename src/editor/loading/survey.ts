import type { FastestPoint, LoadedScene } from '../../nodes/services.ts';
import { fastest } from '../../scene/fastest.ts';
import type { Diagnostic, Scene } from '../../scene/types.ts';
import { validate } from '../../scene/validate.ts';

const REAL_C = 299_792_458;

/** What is told when a scene is opened: its faults, and its fastest point. Objects that cannot be drawn are left out. */
export function loadedScene(read: Scene): LoadedScene {
  const found = validate(read, REAL_C).filter(({ code }) => code !== 'motion.superluminal');
  const broken = new Set(found.flatMap((one) => (one.severity === 'error' ? [placeOf(one)] : [])));
  const objects = read.objects.filter(({ path }) => !broken.has(path));
  const cameras = read.cameras.filter(({ path }) => !broken.has(path));
  const scene = { ...read, objects, cameras, diagnostics: [...read.diagnostics, ...found] };
  const fast = fastestOf(scene);
  return fast ? { scene, fastest: fast } : { scene };
}

const placeOf = ({ place }: Diagnostic): string => place.replace(/^motion of /, '');

function fastestOf(scene: Scene): FastestPoint | undefined {
  const range = [scene.startTime, scene.endTime] as const;
  let best: FastestPoint | undefined;
  for (const object of scene.objects) {
    const { speed, from } = fastest(object, scene.hints.speedOfLight ?? REAL_C, range, best?.speed ?? 0);
    if (speed > (best?.speed ?? 0)) {
      best = { path: object.path, time: Number.isFinite(from) ? from : scene.startTime, speed };
    }
  }
  return best;
}
