import { clamp, dot, float, If, length, max, min, normalize, reflect, select, sqrt } from 'three/tsl';
import type { AreaLight } from '../scene/types.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { mirroredLight } from './brdf.ts';
import type { Receiver } from './lampLight.ts';
import type { SeenLamp } from './lampSeen.ts';
import type { LampShape } from './lampTable.ts';
import { meanLight, meetingOf, type Sending, shiftFrom } from './meeting.ts';
import { faceOutline, type Outline, outlineFlux, tubeOutline } from './outline.ts';
import { frontOf, shaped } from './shaping.ts';

/** A lamp with a size: half axes and radius [m]. */
interface Shape extends Pick<LampShape, 'X' | 'Y'> {
  readonly kind: AreaLight['kind'];
  readonly radius: Float;
}

/**
 * What a surface sends on of the light of a lamp with a size, unhidden, all in the lamp's own frame, where its outline is one of straight edges.
 * The matt part is exact in its irradiance, over which D varies: that is a moment of second order of the outline. Its colour is that of the mean D, its
 * shape that of the mean direction. The glossy part has all light come from the point of the lamp that is nearest to the mirrored ray, with the D of that
 * point, on a surface that is rougher by the lamp's size.
 * Source: Karis 2013, "Real shading in Unreal Engine 4", SIGGRAPH course notes, "Area lights".
 */
export function areaLight(
  { look, rest }: Receiver,
  { kind, radius }: Pick<Shape, 'kind' | 'radius'>,
  { frame, centre, shape, shining }: SeenLamp,
  send: Sending,
): void {
  if (!shape) return;
  const { N, V } = look;
  const lamp = { kind, radius, X: shape.X, Y: shape.Y };
  const toCentre = normalize(centre).toVar();
  const front = frontOf(shape);
  const met = meetingOf(N, rest, frame);
  const shares = (to: Vec3): Float => shaped({ ...shape, front }, to.negate());
  If(kind === 'cylinder' ? dot(centre, centre).greaterThan(0) : dot(centre, front).lessThan(0), () => {
    const { amount, toward } = outlineFlux(seenOutline(outlineOf(lamp, centre)), met.N, toCentre, met.U !== undefined);
    const { D, irradiance } = meanLight(met, amount, toward);
    const mean = toward.div(length(toward).max(1e-12)).toVar();
    const alive = shining?.(mean.mul(distanceAlong(mean, lamp, centre, front)));
    const matt = look.diffuse.mul(irradiance.mul(shares(mean)).div(Math.PI));
    const ray = frame.into(rest.out(normalize(reflect(V.negate(), N)))).toVar();
    const nearest = normalize(nearestTo(ray, lamp, centre, front)).toVar();
    const facing = facingFactor(lamp, centre, toCentre, front).toVar();
    // A mirror shows the lamp's own radiance: so the widening across times that along is Ω/4π.
    const widening = sqrt(facing.div(4 * Math.PI)).toVar();
    const stretch = sqrt(slenderness(lamp, toCentre)).toVar();
    const L = rest.into(frame.out(nearest)).toVar();
    const glossy = mirroredLight(look, L, widening.div(stretch), widening.mul(stretch)).mul(
      facing.mul(shares(nearest)),
    );
    const shift = shiftFrom(met, nearest);
    send(
      { share: alive ? matt.mul(alive) : matt, ...(D && { D }) },
      { share: alive ? glossy.mul(alive) : glossy, ...(shift && { D: shift }) },
    );
  });
}

/** How far away [m] the lamp is in a direction within its outline; of a tube its middle. */
const distanceAlong = (n: Vec3, { kind }: Shape, centre: Vec3, front: Vec3): Float =>
  kind === 'cylinder' ? length(centre) : dot(centre, front).div(dot(n, front).min(-1e-6));

const outlineOf = ({ kind, X, Y, radius }: Shape, centre: Vec3): Outline =>
  kind === 'cylinder' ? tubeOutline(centre, X, radius) : faceOutline(kind === 'rect' ? 'rect' : 'disk', centre, X, Y);

const seenOutline = ({ count, corner }: Outline): Outline => ({ count, corner: (k) => normalize(corner(k)) });

/** Length over breadth, as it is seen. */
function slenderness({ kind, X, Y, radius }: Shape, toCentre: Vec3): Float {
  if (kind === 'disk') return float(1);
  if (kind === 'rect') return length(X).div(length(Y));
  const along = dot(toCentre, normalize(X));
  return length(X)
    .div(radius)
    .mul(sqrt(max(along.mul(along).oneMinus(), 1e-6)));
}

/** Irradiance of a surface that faces it, over its radiance: as of a disk with its area that is seen from its axis, πA/(A + πd²). */
function facingFactor({ kind, X, Y, radius }: Shape, centre: Vec3, toCentre: Vec3, front: Vec3): Float {
  const along = dot(toCentre, normalize(X));
  const facing = (): Float => dot(toCentre, front).negate();
  const shown = (
    kind === 'rect'
      ? length(X).mul(length(Y)).mul(4).mul(facing())
      : kind === 'cylinder'
        ? length(X)
            .mul(radius)
            .mul(4)
            .mul(sqrt(max(along.mul(along).oneMinus(), 0)))
        : radius.mul(radius).mul(Math.PI).mul(facing())
  ).toVar();
  return shown.mul(Math.PI).div(shown.add(dot(centre, centre).mul(Math.PI)).max(1e-12));
}

/** The point of the lamp that is nearest to a unit ray, relative to the ray's beginning. */
function nearestTo(ray: Vec3, lamp: Shape, centre: Vec3, front: Vec3): Vec3 {
  return lamp.kind === 'cylinder' ? nearestOfTube(ray, lamp, centre) : nearestOfFace(ray, lamp, centre, front);
}

function nearestOfFace(ray: Vec3, { kind, X, Y }: Shape, centre: Vec3, front: Vec3): Vec3 {
  const [depth, slope] = [dot(centre, front).toVar(), dot(ray, front).toVar()];
  // A ray that does not come to the face's plane is followed as far as its middle.
  const reach = select(slope.lessThan(-1e-4), min(depth.div(slope.min(-1e-4)), 1e6), length(centre));
  const off = ray.mul(reach).sub(centre).toVar();
  const x = dot(off, X).div(dot(X, X)).toVar();
  const y = dot(off, Y).div(dot(Y, Y)).toVar();
  if (kind === 'rect') return centre.add(X.mul(clamp(x, -1, 1))).add(Y.mul(clamp(y, -1, 1)));
  const inside = sqrt(x.mul(x).add(y.mul(y))).max(1);
  return centre.add(X.mul(x.div(inside))).add(Y.mul(y.div(inside)));
}

function nearestOfTube(ray: Vec3, { X, radius }: Shape, centre: Vec3): Vec3 {
  const slope = dot(ray, X).toVar();
  const spread = dot(X, X).sub(slope.mul(slope)).max(1e-9);
  const s = clamp(slope.mul(dot(ray, centre)).sub(dot(centre, X)).div(spread), -1, 1);
  const axis = centre.add(X.mul(s)).toVar();
  const off = ray.mul(dot(ray, axis).max(0)).sub(axis).toVar();
  return axis.add(off.mul(min(radius.div(length(off).max(1e-9)), 1)));
}
