import { dot, If, length, normalize, reflect, sqrt } from 'three/tsl';
import type { Bool, Float, Vec3 } from '../../../shaders/types.ts';
import { areaSpecular } from '../../brdf/brdf.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import { frontOf, shapingFactor } from '../lightShaping.ts';
import type { LightShape, LightTexels } from '../lightTexels.ts';
import { type LightOutline, outlineFlux } from './lightOutline.ts';
import type { LitSurface } from './litSurface.ts';
import { type AddReflected, dopplerFrom, meanLight, surfaceInLightFrame } from './surfaceInLightFrame.ts';

/** A light with a size, in its own frame: half axes and radius [m], surface → its middle [m], and the unit direction to which it shines. */
export interface PlacedArea extends Pick<LightShape, 'X' | 'Y'> {
  readonly radius: Float;
  readonly center: Vec3;
  readonly front: Vec3;
}

/** What an area light of some shape looks like from a surface. `toCenter`: unit, surface → its middle. */
export interface AreaGeometry {
  /** Whether the surface is where it shines. */
  isLit(light: PlacedArea): Bool;
  /** What it covers of the sky. */
  outline(light: PlacedArea): LightOutline;
  /** How far away [m] it is in a direction within its outline. */
  distanceAlong(n: Vec3, light: PlacedArea): Float;
  /** The point of it that is nearest to a unit ray from the surface, relative to the surface. */
  nearestPoint(ray: Vec3, light: PlacedArea): Vec3;
  /** Area of its image [m²]. */
  projectedArea(light: PlacedArea, toCenter: Vec3): Float;
  /** Length over breadth of its image. */
  aspectRatio(light: PlacedArea, toCenter: Vec3): Float;
}

/**
 * What a surface reflects of the light of an area light, unoccluded, all in the light's own frame, where its outline is one of straight edges.
 * The matt part is exact in its irradiance, over which D varies: that is a moment of second order of the outline. Its colour is that of the mean D, its
 * shape that of the mean direction. The glossy part has all light come from the point of the light that is nearest to the mirrored ray, with the D of that
 * point, on a surface that is rougher by the light's size.
 * Source: Karis 2013, "Real shading in Unreal Engine 4", SIGGRAPH course notes, "Area lights".
 */
export function addAreaLight(
  geometry: AreaGeometry,
  { brdf, rest }: LitSurface,
  { radius }: Pick<LightTexels, 'radius'>,
  { frame, center, shape, aliveFactor }: LightAtEmission,
  addReflected: AddReflected,
): void {
  if (!shape) return;
  const { N, V } = brdf;
  const toCenter = normalize(center).toVar();
  const front = frontOf(shape);
  const light = { radius, X: shape.X, Y: shape.Y, center, front };
  const met = surfaceInLightFrame(N, rest, frame);
  const shares = (to: Vec3): Float => shapingFactor({ ...shape, front }, to.negate());
  If(geometry.isLit(light), () => {
    const { amount, toward } = outlineFlux(
      projectOutline(geometry.outline(light)),
      met.N,
      toCenter,
      met.U !== undefined,
    );
    const { D, irradiance } = meanLight(met, amount, toward);
    const mean = toward.div(length(toward).max(1e-12)).toVar();
    const alive = aliveFactor?.(mean.mul(geometry.distanceAlong(mean, light)));
    const matt = brdf.diffuse.mul(irradiance.mul(shares(mean)).div(Math.PI));
    const ray = frame.into(rest.out(normalize(reflect(V.negate(), N)))).toVar();
    const nearest = normalize(geometry.nearestPoint(ray, light)).toVar();
    const facing = formFactor(geometry.projectedArea(light, toCenter).toVar(), center).toVar();
    // A mirror shows the light's own radiance: so the widening across times that along is Ω/4π.
    const widening = sqrt(facing.div(4 * Math.PI)).toVar();
    const stretch = sqrt(geometry.aspectRatio(light, toCenter)).toVar();
    const L = rest.into(frame.out(nearest)).toVar();
    const glossy = areaSpecular(brdf, L, widening.div(stretch), widening.mul(stretch)).mul(facing.mul(shares(nearest)));
    const shift = dopplerFrom(met, nearest);
    addReflected(
      { share: alive ? matt.mul(alive) : matt, ...(D && { D }) },
      { share: alive ? glossy.mul(alive) : glossy, ...(shift && { D: shift }) },
    );
  });
}

const projectOutline = ({ count, corner }: LightOutline): LightOutline => ({
  count,
  corner: (k) => normalize(corner(k)),
});

/** Irradiance of a surface that faces it, over its radiance: as of a disk with its area that is seen from its axis, πA/(A + πd²). */
const formFactor = (area: Float, center: Vec3): Float =>
  area.mul(Math.PI).div(area.add(dot(center, center).mul(Math.PI)).max(1e-12));
