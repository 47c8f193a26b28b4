import { surveyed } from '../../nodes/geometry/surveyed.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import { REAL_C } from '../../scene/fastestIn.ts';
import type { Diagnostic, Scene } from '../../scene/types.ts';
import { validate } from '../../scene/validate.ts';

/** What is told when a scene is opened: its faults, and its fastest point. Objects that cannot be drawn are left out. */
export function loadedScene(read: Scene): LoadedScene {
  const found = validate(read, REAL_C).filter(({ code }) => code !== 'motion.superluminal');
  const broken = new Set(found.flatMap((one) => (one.severity === 'error' ? [placeOf(one)] : [])));
  const objects = read.objects.filter(({ path }) => !broken.has(path));
  const cameras = read.cameras.filter(({ path }) => !broken.has(path));
  return surveyed({ ...read, objects, cameras, diagnostics: [...read.diagnostics, ...found] });
}

const placeOf = ({ place }: Diagnostic): string => place.replace(/^motion of /, '');
