import { dot, normalize } from 'three/tsl';
import type { Float, Vec3 } from '../shaders/types.ts';
import { areaLight } from './areaShade.ts';
import { type Look, reflectance } from './brdf.ts';
import { lampSeen } from './lampSeen.ts';
import type { LampTexels } from './lampTable.ts';
import { type Gathering, IRRADIANCE } from './radiance.ts';
import { passageBetween, type Rest } from './restFrame.ts';
import { frontOf, shaped } from './shaping.ts';
import type { Uniforms } from './uniforms.ts';

/** A surface that a lamp shines on: `dx` observer → surface [m] and `time` after his [m of light], world. */
export interface Receiver {
  readonly look: Look;
  readonly dx: Vec3;
  readonly time: Float;
  readonly rest: Rest;
  readonly uniforms: Uniforms;
}

/** What a surface sends on of a lamp's light, unhidden. Spheres are points in their middle: E = D² I/d² with d in the lamp's frame. */
export function lampLight(receiver: Receiver, lamp: LampTexels, eye: Gathering): void {
  const { look, dx, time, rest, uniforms } = receiver;
  const seen = lampSeen(lamp, dx, time, uniforms);
  const passage = { ...passageBetween(seen.n, rest, seen.frame), ...(lamp.source && { source: lamp.source }) };
  if (lamp.kind !== 'sphere') {
    areaLight(receiver, lamp, seen, passage, eye);
    return;
  }
  const { centre, shape, shining } = seen;
  const open = shape ? shaped({ ...shape, front: frontOf(shape) }, normalize(centre).negate()) : undefined;
  const fall = dot(centre, centre).max(1e-12).reciprocal();
  const share = [open, shining].reduce<Float>((product, factor) => (factor ? product.mul(factor) : product), fall);
  eye.send(lamp.color, reflectance(look, rest.into(seen.n)).mul(share), passage, IRRADIANCE);
}
