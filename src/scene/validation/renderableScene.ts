import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import type { Diagnostic, Scene } from '../types.ts';
import { validate } from './validate.ts';

export interface RenderableScene {
  readonly scene: Scene;
  /** What else is to be said of it, of which nothing is left out. */
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * A scene without what no picture can be made of at any speed of light; each thing that is left out is told. Of two objects of one path the
 * first stays. What is only too fast for one speed of light is left to those who know it.
 */
export function renderableScene(scene: Scene): RenderableScene {
  const found = validate(scene, SPEED_OF_LIGHT).filter(({ code }) => code !== 'motion.superluminal');
  const errors = found.filter(({ severity }) => severity === 'error');
  const remarks = found.filter(({ severity }) => severity !== 'error');
  if (errors.length === 0) return { scene, diagnostics: remarks };
  const broken = new Set(errors.flatMap((one) => (one.code === DUPLICATE ? [] : [pathOf(one)])));
  const isWhole = ({ path }: { readonly path: string }): boolean => !broken.has(path);
  const seen = new Set<string>();
  const isFirst = ({ path }: { readonly path: string }): boolean => !seen.has(path) && seen.add(path) !== undefined;
  const told = errors.map(
    (one): Diagnostic => ({ ...one, severity: 'warning', message: `${one.message}; it is left out` }),
  );
  return {
    scene: {
      ...scene,
      objects: scene.objects.filter(isWhole).filter(isFirst),
      cameras: scene.cameras.filter(isWhole),
      lights: scene.lights.filter(isWhole),
      diagnostics: [...scene.diagnostics, ...told],
    },
    diagnostics: remarks,
  };
}

const DUPLICATE = 'scene.duplicate-path';

const pathOf = ({ place }: Diagnostic): string => place.replace(/^motion of /, '');
