import { uniform } from 'three/tsl';
import { Vector3 } from 'three/webgpu';
import { type Vec3, ZERO } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import { slowed } from '../../physics/worldLines/shallowCone.ts';

/** The observer, as shaders read him. */
export function makeObserverUniforms() {
  return {
    /** γβ and γ. */
    u: uniform(new Vector3()),
    gamma: uniform(1),
    /** λ of the cone ct′ = −λr′, and γβ and γ of the velocity λβ, in the view from slice to cone. */
    coneSlope: uniform(1),
    slowedU: uniform(new Vector3()),
    slowedGamma: uniform(1),
    /** From him to the camera (`ViewPoint.vantage`) [m]. */
    vantage: uniform(new Vector3()),
  };
}

type ObserverUniforms = ReturnType<typeof makeObserverUniforms>;

export function setObserverUniforms(
  uniforms: ObserverUniforms,
  { u, coneSlope }: { readonly u: Vec3; readonly coneSlope: number },
  vantage: Vec3 | undefined,
): void {
  const slow = slowed(u, coneSlope);
  uniforms.u.value.set(...u);
  uniforms.gamma.value = gamma(u);
  uniforms.coneSlope.value = coneSlope;
  uniforms.slowedU.value.set(...slow);
  uniforms.slowedGamma.value = gamma(slow);
  uniforms.vantage.value.set(...(vantage ?? ZERO));
}
