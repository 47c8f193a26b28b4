import { add, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { VIEWS } from '../views/views.ts';
import { perspective } from './lenses/perspectiveLens.ts';
import type { OutsideCamera } from './outsideCamera.ts';
import type { RenderSettings, ViewPoint } from './view.ts';

/** From the observer to the camera that his picture is drawn from [m]. */
const offsetOf = ({ position }: ViewPoint, { place, follows }: OutsideCamera): Vec3 =>
  follows ? place : sub(place, position);

/**
 * The view point that a picture or one of its G-buffers is drawn from: the observer's own, or that of its outside camera. The world's moment (c = ∞) is the
 * same for every observer, so that the camera is one there, and its light is what he would see; of all else it shows what the observer himself sees, from aside.
 */
export function drawnFrom(view: ViewPoint, settings: Pick<RenderSettings, 'outside' | 'view'>): ViewPoint {
  const { outside } = settings;
  if (!outside) return view;
  const { vantage: _, ...observer } = view;
  const { orientation, fovY } = outside;
  const camera = { ...observer, orientation, lens: perspective(fovY) };
  const offset = offsetOf(view, outside);
  return VIEWS[settings.view].relativistic
    ? { ...camera, vantage: offset }
    : { ...camera, position: add(view.position, offset) };
}

/** From the camera of a picture to the observer [m]; zero if it is at his eye. */
export const toObserver = (view: ViewPoint, { outside }: Pick<RenderSettings, 'outside'>): Vec3 =>
  outside ? scale(offsetOf(view, outside), -1) : ZERO;
