import {
  abs,
  acos,
  atan,
  clamp,
  cross,
  dot,
  float,
  If,
  inverseSqrt,
  length,
  max,
  normalize,
  reflect,
  select,
  sqrt,
  vec3,
  vec4,
} from 'three/tsl';
import type { SphereLight } from '../../../scene/types.ts';
import type { Float, Vec3 } from '../../../shaders/types.ts';
import { areaSpecular } from '../../brdf/brdf.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import { frontOf, shapingFactor } from '../lightShaping.ts';
import type { RestFrameNodes } from '../restFrame.ts';
import type { LightShader } from './lightShader.ts';
import type { LitSurface } from './litSurface.ts';
import {
  type AddReflected,
  dopplerFrom,
  type MeanLight,
  meanLight,
  type SurfaceInLightFrame,
  surfaceInLightFrame,
} from './surfaceInLightFrame.ts';

/** Directions about a unit `axis`, up to an angle α from it: sin² α and cos α. */
interface SphericalCap {
  readonly axis: Vec3;
  readonly sine2: Float;
  readonly cosine: Float;
}

export const SPHERE_LIGHT: LightShader<SphereLight> = {
  maxUnrolled: 2,
  needsAxes: false,
  extents: ({ radius }) => ({ x: 1, y: 1, radius, gain: 1 }),
  bulbRadius: ({ radius }) => radius,
  addReflected: (receiver, { radius }, emitter, add) => sphereLight(receiver, radius, emitter, add),
  /** Perpendicular to the direction to it. */
  silhouette({ radius, offset }) {
    const to = normalize(offset).toVar();
    const aside = abs(to.x)
      .lessThan(0.7)
      .select(vec3(1, 0, 0), vec3(0, 1, 0));
    const X = normalize(cross(to, aside)).toVar();
    return [X.mul(radius), cross(to, X).mul(radius)];
  },
  isParallelogram: false,
};

/**
 * What a surface reflects of the light of a sphere, unoccluded. Its outline is a circle in every frame (Penrose 1959, "The apparent shape of a relativistically
 * moving sphere", Proc. Camb. Phil. Soc. 55). The diffuse part is exact, except that where the horizon cuts the sphere, D⁴ is that of the whole sphere on a
 * surface tilted towards it until nothing is cut off. The specular part takes all light as coming from the direction within the outline that is nearest to the
 * mirrored ray, with the D of that direction, on a surface that is rougher by the sphere's size (Karis 2013, see areaLight.ts).
 */
function sphereLight(
  { brdf, rest }: LitSurface,
  radius: Float,
  emitter: LightAtEmission,
  addReflected: AddReflected,
): void {
  const { frame, center, shape, aliveFactor } = emitter;
  const { N, V } = brdf;
  const own = capOfSphere(center, radius);
  const seen = frame.doppler || rest.doppler ? boostedCap(own, frame, rest) : own;
  const height = dot(N, seen.axis).toVar();
  // Inside the sphere it fills the hemisphere.
  const irradiance = select(own.sine2.lessThan(MAX_SINE2), capIrradiance(seen, height), Math.PI).toVar();
  If(irradiance.greaterThan(0), () => {
    const shaping = shape && shapingFactor({ ...shape, front: frontOf(shape) }, own.axis.negate());
    const factor = (
      shaping && aliveFactor ? shaping.mul(aliveFactor(center)) : (shaping ?? aliveFactor?.(center) ?? float(1))
    ).toVar();
    const tilted = N.add(seen.axis.mul(max(sqrt(seen.sine2).sub(height), 0))).toVar();
    const { D, irradiance: wholeIrradiance } = capLight(own, surfaceInLightFrame(tilted, rest, frame));
    const whole = seen.sine2.mul(dot(tilted, seen.axis)).mul(Math.PI);
    const toward = nearestInCap(seen, normalize(reflect(V.negate(), N)).toVar()).toVar();
    const widening = sqrt(seen.sine2).div(2).toVar();
    const specular = areaSpecular(brdf, toward, widening, widening).mul(seen.sine2.mul(factor).mul(Math.PI));
    const shift = dopplerFrom(surfaceInLightFrame(N, rest, frame), frame.into(rest.out(toward)));
    addReflected(
      {
        reflectance: brdf.diffuse.mul(irradiance.mul(wholeIrradiance).mul(factor).div(whole.mul(Math.PI))),
        ...(D && { D }),
      },
      // The solid angle is that in the surface's frame; times D² it is that in the light's.
      shift ? { reflectance: specular.mul(shift.mul(shift)), D: shift } : { reflectance: specular },
    );
  });
}

/** Upper limit of sin² α, reached where the surface touches the sphere. */
const MAX_SINE2 = 0.9999;

function capOfSphere(center: Vec3, radius: Float): SphericalCap {
  const d2 = dot(center, center).max(1e-12).toVar();
  const sine2 = radius.mul(radius).div(d2).min(MAX_SINE2).toVar();
  return { axis: center.mul(inverseSqrt(d2)).toVar(), sine2, cosine: sqrt(sine2.oneMinus()).toVar() };
}

/** The edge of a cap is where C·(n, 1) = 0 for the four-vector C = (axis, −cos α), whose square sin² α is invariant. */
function boostedCap(
  { axis, sine2, cosine }: SphericalCap,
  source: RestFrameNodes,
  receiver: RestFrameNodes,
): SphericalCap {
  const C = receiver.boostInto(source.boostOut(vec4(axis, cosine.negate()))).toVar();
  const across = length(C.xyz).toVar();
  return {
    axis: C.xyz.div(across).toVar(),
    sine2: sine2.div(across.mul(across)).toVar(),
    cosine: C.w.negate().div(across).toVar(),
  };
}

/**
 * Irradiance of light of radiance 1 from a cap whose axis has the cosine `height` to the normal, cut off at the horizon.
 * Source: Lagarde and de Rousiers 2014, "Moving Frostbite to physically based rendering", SIGGRAPH course notes, listing 7.
 */
function capIrradiance({ sine2, cosine }: SphericalCap, height: Float): Float {
  const x = cosine.div(sqrt(sine2)).toVar();
  const across = sqrt(max(height.mul(height).oneMinus(), 1e-8)).toVar();
  const y = clamp(x.mul(height).div(across).negate(), -1, 1).toVar();
  const rim = across.mul(sqrt(y.mul(y).oneMinus())).toVar();
  const cut = height
    .mul(acos(y))
    .sub(x.mul(rim))
    .mul(sine2)
    .add(atan(rim.div(x)));
  const whole = max(height, 0).mul(sine2).mul(Math.PI);
  return select(height.mul(height).greaterThan(sine2), whole, max(cut, 0));
}

/** The light of the whole cap, ignoring the horizon: ∫ dΩ = 2π(1 − cos α), ∫ n dΩ = π sin² α · axis, ∫ (n·axis)² dΩ = ⅔π(1 − cos³ α). */
function capLight({ axis, sine2, cosine }: SphericalCap, surface: SurfaceInLightFrame): MeanLight {
  const { N } = surface;
  const solidAngle = sine2
    .div(cosine.add(1))
    .mul(2 * Math.PI)
    .toVar();
  const along = solidAngle.mul(cosine.mul(cosine).add(cosine).add(1)).div(3).toVar();
  const across = solidAngle.sub(along).div(2).toVar();
  const first = axis.mul(sine2.mul(Math.PI)).toVar();
  const toward = first
    .mul(N.w)
    .add(N.xyz.mul(across))
    .add(axis.mul(along.sub(across).mul(dot(axis, N.xyz))));
  return meanLight(surface, solidAngle.mul(N.w).add(dot(first, N.xyz)).toVar(), toward);
}

/** The direction within a cap that is nearest to a unit `ray`. */
function nearestInCap({ axis, sine2, cosine }: SphericalCap, ray: Vec3): Vec3 {
  const along = dot(ray, axis).toVar();
  const aside = ray.sub(axis.mul(along)).toVar();
  const edge = axis.mul(cosine).add(aside.mul(sqrt(sine2).div(length(aside).max(1e-6))));
  return select(along.greaterThan(cosine), ray, edge);
}
