import { rotate } from '../../src/math/quat.ts';
import { length, normalize, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import type { Scene } from '../../src/scene/types.ts';
import { framingCamera, lookAtOrientation, observerFromCamera } from '../../src/scene/view/camera.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../src/scene/view/view.ts';
import type { View } from '../../src/scene/views/views.ts';
import { type ExampleName, speedOfLight } from '../examples/open.ts';
import { DATA_SETTINGS } from '../gpu/support/dataSettings.ts';
import type { ExtraScene } from './extraScenes.ts';
import { shownAt } from './pixelOracle.ts';

export const BETAS = [0, 0.5, 0.9, 0.99] as const;

/** The observer's direction of motion on the camera's axes: forward, or obliquely for scenes with objects beside the path. */
const COURSES: Partial<Record<ExampleName, Vec3>> = {
  dice: [0.8, 0, -0.6],
  sphere: [-0.6, 0, -0.8],
  saturn: [0.5, 0.2, -1],
  ladder: [1, 0, -0.3],
};

/** One picture. */
export interface TestView {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
}

/** A view of an example at the command line's default position and time, at a speed β. */
export function exampleFrame(name: ExampleName, scene: Scene, view: View, beta: number): TestView {
  const c = speedOfLight(scene);
  const t = scene.hints.openAt ?? scene.startTime;
  const { position, orientation, lens } = observerFromCamera(scene.cameras[0] ?? framingCamera(scene), t, c);
  const course = rotate(orientation, normalize(COURSES[name] ?? [0, 0, -1]));
  const u = properVelocity(scale(course, beta));
  return {
    view: { t, position, u, orientation, lens },
    settings: { ...DATA_SETTINGS, view, speedOfLight: c },
  };
}

/** A view centred on the subject that shows `extent` metres at its apparent distance; lengths perpendicular to the line of sight are not contracted. */
export function extraFrame(
  { scene, t, eye, subject, extent, towards }: ExtraScene,
  view: View,
  beta: number,
  coneSlope = DEFAULT_SETTINGS.coneSlope,
): TestView {
  const u = properVelocity(scale(towards, beta));
  const dx = sub(subject, eye);
  const settings = { ...DATA_SETTINGS, view, coneSlope, speedOfLight: speedOfLight(scene) };
  const shown = shownAt(dx, u, settings);
  const fovY = Math.min(1.9, 2 * Math.atan(extent / 2 / length(shown)));
  const orientation = lookAtOrientation(shown, [0, 1, 0]);
  return {
    view: { t, position: eye, u, orientation, lens: perspective(fovY) },
    settings,
  };
}
