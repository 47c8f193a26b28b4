import { dot, normalize } from 'three/tsl';
import type { Float, Vec3 } from '../shaders/types.ts';
import { areaLight } from './areaShade.ts';
import { ballLight } from './ballShade.ts';
import { type Look, reflectance } from './brdf.ts';
import { lampSeen, type SeenLamp } from './lampSeen.ts';
import type { LampTexels } from './lampTable.ts';
import type { Part, Sending } from './meeting.ts';
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

/** The share of a lamp's light that gets to a surface past what is in its way. */
export type Shelter = (lamp: LampTexels, seen: SeenLamp) => Float | undefined;

/** What a surface sends on of a lamp's light; `shelter`: of one that throws shadows. */
export function lampLight(receiver: Receiver, lamp: LampTexels, eye: Gathering, shelter?: Shelter): void {
  const { dx, time, uniforms } = receiver;
  const seen = lampSeen(lamp, dx, time, uniforms);
  const passing = shelter?.(lamp, seen)?.toVar();
  const { source, colored } = lamp;
  const sent = ({ share, D }: Part): void =>
    eye.send(
      lamp.color,
      passing ? share.mul(passing) : share,
      { ...(D && { D }), ...(source && { source }), ...(colored !== undefined && { colored }) },
      IRRADIANCE,
    );
  const send: Sending = (matt, glossy) => {
    if (!matt.D && !glossy.D) return sent({ share: matt.share.add(glossy.share) });
    sent(matt);
    sent(glossy);
  };
  if (lamp.kind === 'point') sent(pointLight(receiver, seen));
  else if (lamp.kind === 'sphere') ballLight(receiver, lamp.radius, seen, send);
  else areaLight(receiver, { kind: lamp.kind, radius: lamp.radius }, seen, send);
}

/** E = D² I/d² with d in the lamp's frame. */
function pointLight({ look, rest }: Receiver, { n, frame, centre, shape, shining }: SeenLamp): Part {
  const open = shape && shaped({ ...shape, front: frontOf(shape) }, normalize(centre).negate());
  const fall = dot(centre, centre).max(1e-12).reciprocal();
  const share = [open, shining?.(centre)].reduce<Float>(
    (product, factor) => (factor ? product.mul(factor) : product),
    fall,
  );
  return { share: reflectance(look, rest.into(n)).mul(share), ...passageBetween(n, rest, frame) };
}
