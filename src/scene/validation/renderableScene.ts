import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import type { Diagnostic, Scene } from '../types.ts';
import { objectPath } from './motionFindings.ts';
import { validate } from './validate.ts';

export interface RenderableScene {
  readonly scene: Scene;
  /** Warnings about objects that are kept. */
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Removes what cannot be rendered at any speed of light and reports it. Of two objects with the same path the first stays. Superluminal motion depends on the
 * speed of light, so it is left to callers who know that.
 */
export function renderableScene(scene: Scene): RenderableScene {
  const found = validate(scene, SPEED_OF_LIGHT).filter(({ code }) => code !== 'motion.superluminal');
  const errors = found.filter(({ severity }) => severity === 'error');
  const remarks = found.filter(({ severity }) => severity !== 'error');
  if (errors.length === 0) return { scene, diagnostics: remarks };
  const broken = new Set(errors.flatMap((one) => (one.code === DUPLICATE ? [] : [objectPath(one)])));
  const isWhole = ({ path }: { readonly path: string }): boolean => !broken.has(path);
  const seen = new Set<string>();
  const isFirst = ({ path }: { readonly path: string }): boolean => !seen.has(path) && seen.add(path) !== undefined;
  const removed = errors.map(
    (one): Diagnostic => ({ ...one, severity: 'warning', message: msg`${one.message}; it is left out` }),
  );
  return {
    scene: {
      ...scene,
      objects: scene.objects.filter(isWhole).filter(isFirst),
      cameras: scene.cameras.filter(isWhole),
      lights: scene.lights.filter(isWhole),
      diagnostics: [...scene.diagnostics, ...removed],
    },
    diagnostics: remarks,
  };
}

const DUPLICATE = 'scene.duplicate-path';
