import { dot, If, length, normalize, reflect, sqrt } from 'three/tsl';
import type { Bool, Float, Vec3 } from '../../../shaders/types.ts';
import { areaSpecular } from '../../brdf/brdf.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import { frontOf, shapingFactor } from '../lightShaping.ts';
import type { LightShape, LightTexels } from '../lightTexels.ts';
import { type LightOutline, outlineFlux } from './lightOutline.ts';
import type { LitSurface } from './litSurface.ts';
import { type AddReflected, dopplerFrom, meanLight, surfaceInLightFrame } from './surfaceInLightFrame.ts';

/** An area light in its rest frame: half axes and radius [m], surface → its centre [m], and the unit direction in which it shines. */
export interface PlacedArea extends Pick<LightShape, 'X' | 'Y'> {
  readonly radius: Float;
  readonly center: Vec3;
  readonly front: Vec3;
}

/** Geometry of an area light as seen from a surface. `toCenter`: unit, surface → its centre. */
export interface AreaGeometry {
  /** Whether the surface is on the side to which it shines. */
  isLit(light: PlacedArea): Bool;
  /** Its outline, relative to the surface. */
  outline(light: PlacedArea): LightOutline;
  /** Its distance [m] in a direction within its outline. */
  distanceAlong(n: Vec3, light: PlacedArea): Float;
  /** Its point nearest to a unit ray from the surface, relative to the surface [m]. */
  nearestPoint(ray: Vec3, light: PlacedArea): Vec3;
  /** Projected area [m²]. */
  projectedArea(light: PlacedArea, toCenter: Vec3): Float;
  /** Aspect ratio of its projection. */
  aspectRatio(light: PlacedArea, toCenter: Vec3): Float;
}

/**
 * What a surface reflects of an area light, unoccluded, computed in the light's rest frame, where its outline has straight edges.
 * The irradiance of the diffuse part is exact though D varies over the light: it is a second moment of the outline. Its colour is that of the mean D, its
 * shaping that of the mean direction. The specular part takes all light as coming from the point of the light nearest to the mirrored ray, with the D of that
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
  const surface = surfaceInLightFrame(N, rest, frame);
  const shaping = (to: Vec3): Float => shapingFactor({ ...shape, front }, to.negate());
  If(geometry.isLit(light), () => {
    const { amount, toward } = outlineFlux(
      projectOutline(geometry.outline(light)),
      surface.N,
      toCenter,
      surface.U !== undefined,
    );
    const { D, irradiance } = meanLight(surface, amount, toward);
    const mean = toward.div(length(toward).max(1e-12)).toVar();
    const alive = aliveFactor?.(mean.mul(geometry.distanceAlong(mean, light)));
    const diffuse = brdf.diffuse.mul(irradiance.mul(shaping(mean)).div(Math.PI));
    const ray = frame.into(rest.out(normalize(reflect(V.negate(), N)))).toVar();
    const nearest = normalize(geometry.nearestPoint(ray, light)).toVar();
    const facing = formFactor(geometry.projectedArea(light, toCenter).toVar(), center).toVar();
    // The product of the widenings across and along is Ω/4π, so that a mirror shows the light's own radiance.
    const widening = sqrt(facing.div(4 * Math.PI)).toVar();
    const stretch = sqrt(geometry.aspectRatio(light, toCenter)).toVar();
    const L = rest.into(frame.out(nearest)).toVar();
    const specular = areaSpecular(brdf, L, widening.div(stretch), widening.mul(stretch)).mul(
      facing.mul(shaping(nearest)),
    );
    const shift = dopplerFrom(surface, nearest);
    addReflected(
      { reflectance: alive ? diffuse.mul(alive) : diffuse, ...(D && { D }) },
      { reflectance: alive ? specular.mul(alive) : specular, ...(shift && { D: shift }) },
    );
  });
}

const projectOutline = ({ count, corner }: LightOutline): LightOutline => ({
  count,
  corner: (k) => normalize(corner(k)),
});

/** Irradiance of a facing surface over the light's radiance, as from the axis of a disk of the same area: πA/(A + πd²). */
const formFactor = (area: Float, center: Vec3): Float =>
  area.mul(Math.PI).div(area.add(dot(center, center).mul(Math.PI)).max(1e-12));
