import { clamp, dot, float, If, length, max, min, normalize, reflect, select, sqrt } from 'three/tsl';
import type { AreaLight } from '../../scene/types.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { LightAtEmission } from '../lights/lightAtEmission.ts';
import { frontOf, shapingFactor } from '../lights/lightShaping.ts';
import type { LightShape } from '../lights/lightTable.ts';
import { areaSpecular } from './brdf.ts';
import { faceOutline, type LightOutline, outlineFlux, tubeOutline } from './lightOutline.ts';
import type { LitSurface } from './litSurface.ts';
import { type AddReflected, dopplerFrom, meanLight, surfaceInLightFrame } from './surfaceInLightFrame.ts';

/** A lamp with a size: half axes and radius [m]. */
interface AreaShape extends Pick<LightShape, 'X' | 'Y'> {
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
  { brdf: look, rest }: LitSurface,
  { kind, radius }: Pick<AreaShape, 'kind' | 'radius'>,
  { frame, center, shape, aliveFactor: shining }: LightAtEmission,
  addReflected: AddReflected,
): void {
  if (!shape) return;
  const { N, V } = look;
  const lamp = { kind, radius, X: shape.X, Y: shape.Y };
  const toCenter = normalize(center).toVar();
  const front = frontOf(shape);
  const met = surfaceInLightFrame(N, rest, frame);
  const shares = (to: Vec3): Float => shapingFactor({ ...shape, front }, to.negate());
  If(kind === 'cylinder' ? dot(center, center).greaterThan(0) : dot(center, front).lessThan(0), () => {
    const { amount, toward } = outlineFlux(
      projectOutline(outlineOf(lamp, center)),
      met.N,
      toCenter,
      met.U !== undefined,
    );
    const { D, irradiance } = meanLight(met, amount, toward);
    const mean = toward.div(length(toward).max(1e-12)).toVar();
    const alive = shining?.(mean.mul(distanceAlong(mean, lamp, center, front)));
    const matt = look.diffuse.mul(irradiance.mul(shares(mean)).div(Math.PI));
    const ray = frame.into(rest.out(normalize(reflect(V.negate(), N)))).toVar();
    const nearest = normalize(nearestPoint(ray, lamp, center, front)).toVar();
    const facing = formFactor(lamp, center, toCenter, front).toVar();
    // A mirror shows the lamp's own radiance: so the widening across times that along is Ω/4π.
    const widening = sqrt(facing.div(4 * Math.PI)).toVar();
    const stretch = sqrt(aspectRatio(lamp, toCenter)).toVar();
    const L = rest.into(frame.out(nearest)).toVar();
    const glossy = areaSpecular(look, L, widening.div(stretch), widening.mul(stretch)).mul(facing.mul(shares(nearest)));
    const shift = dopplerFrom(met, nearest);
    addReflected(
      { share: alive ? matt.mul(alive) : matt, ...(D && { D }) },
      { share: alive ? glossy.mul(alive) : glossy, ...(shift && { D: shift }) },
    );
  });
}

/** How far away [m] the lamp is in a direction within its outline; of a tube its middle. */
const distanceAlong = (n: Vec3, { kind }: AreaShape, center: Vec3, front: Vec3): Float =>
  kind === 'cylinder' ? length(center) : dot(center, front).div(dot(n, front).min(-1e-6));

const outlineOf = ({ kind, X, Y, radius }: AreaShape, center: Vec3): LightOutline =>
  kind === 'cylinder' ? tubeOutline(center, X, radius) : faceOutline(kind === 'rect' ? 'rect' : 'disk', center, X, Y);

const projectOutline = ({ count, corner }: LightOutline): LightOutline => ({
  count,
  corner: (k) => normalize(corner(k)),
});

/** Length over breadth, as it is seen. */
function aspectRatio({ kind, X, Y, radius }: AreaShape, toCenter: Vec3): Float {
  if (kind === 'disk') return float(1);
  if (kind === 'rect') return length(X).div(length(Y));
  const along = dot(toCenter, normalize(X));
  return length(X)
    .div(radius)
    .mul(sqrt(max(along.mul(along).oneMinus(), 1e-6)));
}

/** Irradiance of a surface that faces it, over its radiance: as of a disk with its area that is seen from its axis, πA/(A + πd²). */
function formFactor({ kind, X, Y, radius }: AreaShape, center: Vec3, toCenter: Vec3, front: Vec3): Float {
  const along = dot(toCenter, normalize(X));
  const facing = (): Float => dot(toCenter, front).negate();
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
  return shown.mul(Math.PI).div(shown.add(dot(center, center).mul(Math.PI)).max(1e-12));
}

/** The point of the lamp that is nearest to a unit ray, relative to the ray's beginning. */
function nearestPoint(ray: Vec3, lamp: AreaShape, center: Vec3, front: Vec3): Vec3 {
  return lamp.kind === 'cylinder'
    ? nearestPointOnTube(ray, lamp, center)
    : nearestPointOnFace(ray, lamp, center, front);
}

function nearestPointOnFace(ray: Vec3, { kind, X, Y }: AreaShape, center: Vec3, front: Vec3): Vec3 {
  const [depth, slope] = [dot(center, front).toVar(), dot(ray, front).toVar()];
  // A ray that does not come to the face's plane is followed as far as its middle.
  const reach = select(slope.lessThan(-1e-4), min(depth.div(slope.min(-1e-4)), 1e6), length(center));
  const off = ray.mul(reach).sub(center).toVar();
  const x = dot(off, X).div(dot(X, X)).toVar();
  const y = dot(off, Y).div(dot(Y, Y)).toVar();
  if (kind === 'rect') return center.add(X.mul(clamp(x, -1, 1))).add(Y.mul(clamp(y, -1, 1)));
  const inside = sqrt(x.mul(x).add(y.mul(y))).max(1);
  return center.add(X.mul(x.div(inside))).add(Y.mul(y.div(inside)));
}

function nearestPointOnTube(ray: Vec3, { X, radius }: AreaShape, center: Vec3): Vec3 {
  const slope = dot(ray, X).toVar();
  const spread = dot(X, X).sub(slope.mul(slope)).max(1e-9);
  const s = clamp(slope.mul(dot(ray, center)).sub(dot(center, X)).div(spread), -1, 1);
  const axis = center.add(X.mul(s)).toVar();
  const off = ray.mul(dot(ray, axis).max(0)).sub(axis).toVar();
  return axis.add(off.mul(min(radius.div(length(off).max(1e-9)), 1)));
}
