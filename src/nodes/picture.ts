import type { Evaluation } from '../graph/evaluate.ts';
import { type Vec3, ZERO } from '../math/vec3.ts';
import { isFinished, type Plan } from '../scene/plan.ts';
import type { SceneCamera } from '../scene/types.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { FalseColor, Scale } from '../spectrum/falseColor.ts';
import type { Picture } from './define.ts';

/** The picture that an evaluation of the output node gave; undefined where it failed. */
export const pictureOf = ({ target }: Evaluation): Picture | undefined =>
  target.status === 'done' ? (target.outputs.picture as Picture) : undefined;

/** The camera that a picture is taken with; the Scene node sees to it that there is one. */
export const cameraOf = ({ scene, camera }: Picture): SceneCamera =>
  scene.cameras.find(({ path }) => path === camera) ?? scene.cameras[0]!;

/**
 * The observer's velocity at the start [c], where the camera does not bring it along: as in the page, one who does not ride the camera begins at rest
 * in it; in a film he goes with it.
 */
export const startingBeta = ({ scene, ride }: Picture, film: boolean): Vec3 | undefined =>
  scene.hints.beta ?? (ride || film ? undefined : ZERO);

/** The scale that false colours are to have; undefined: none is known yet. */
export type ScaleOf = (kind: FalseColor) => Scale | undefined;

/** What the renderer needs of a picture; `metered`: the exposure that its metering sets [EV]. */
export function renderSettings(picture: Picture, metered: number, scaleOf: ScaleOf = () => undefined): RenderSettings {
  const scale = picture.falseColor === 'none' ? undefined : scaleOf(picture.falseColor);
  return {
    view: picture.view,
    lightDelay: picture.lightDelay,
    aberration: picture.aberration,
    colors: picture.colors,
    dopplerMix: picture.dopplerMix,
    beaming: picture.beaming,
    shadows: picture.shadows,
    solver: picture.solver,
    iterations: picture.iterations,
    damping: picture.damping,
    antialiasing: picture.antialiasing,
    grid: picture.grid,
    tone: picture.tone,
    exposure: picture.exposure + (isFinished(picture.plan) ? 0 : metered),
    ...(!picture.occlusion && { occlusionRadius: 0 }),
    ...(scale && picture.falseColor !== 'none' && { falseColors: { kind: picture.falseColor, ...scale } }),
    ...(picture.plan && { plan: exposedPlan(picture.plan, metered, scaleOf) }),
    speedOfLight: picture.speedOfLight,
  };
}

/** A plan with the exposures and scales that were measured. */
export function exposedPlan(plan: Plan, metered: number, scaleOf: ScaleOf): Plan {
  const steps = plan.steps.map((step) => {
    if (step.kind === 'tone' && step.metering !== 'manual') return { ...step, exposure: step.exposure + metered };
    const scale = step.kind === 'false-colour' ? scaleOf(step.of) : undefined;
    return scale ? { ...step, scale } : step;
  });
  return { ...plan, steps };
}
