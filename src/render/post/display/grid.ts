import { abs, clamp, dot, exp, Fn, fwidth, max, mix, select, smoothstep, vec2, vec3, vec4 } from 'three/tsl';
import type { Float, Vec2, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';

/**
 * The ground's reference grid, (colour, coverage): straight lines in the observer's frame, as a plane below the observer would look without relativity.
 * `nPrime`: the pixel's direction; `depth`: apparent distance of the surface there [m]; nearer surfaces hide the grid.
 */
export const gridOver = (
  nPrime: Vec3,
  depth: Float,
  { ground, gridStep, zenith, gridEast, gridNorth }: FrameUniforms,
): Vec4 =>
  Fn(() => {
    const down = dot(nPrime, zenith).negate().toVar();
    const steep = select(abs(down).greaterThan(1e-5), down, 1e-5).toVar();
    const distance = ground.x.div(steep).toVar();
    const place = vec2(dot(nPrime, gridEast), dot(nPrime, gridNorth))
      .mul(distance)
      .add(ground.yz)
      .div(gridStep)
      .toVar();
    const footprint = max(fwidth(place), 1e-6).toVar();
    const minor = lines(place, footprint, 1.1);
    const major = lines(place.div(10), footprint.div(10), 1.6);
    const faded = exp(distance.div(gridStep.mul(120)).pow(2).negate());
    const visible = distance.greaterThan(0).and(distance.lessThan(depth.mul(1.02)));
    const cover = max(minor.mul(0.55), major.mul(0.9)).mul(faded);
    const color = mix(vec3(0.02, 0.42, 0.62), vec3(0.05, 0.75, 0.95), major);
    return vec4(color, select(visible, cover, 0));
  })();

/** Coverage of lines at integers, `width` pixels wide; where lines are closer than pixels they fade to their mean. */
function lines(place: Vec2, footprint: Vec2, width: number): Float {
  const pixelDistance = abs(place.add(0.5).fract().sub(0.5)).div(footprint);
  const cover = smoothstep(width / 2 - 0.5, width / 2 + 0.5, pixelDistance).oneMinus();
  const density = clamp(footprint.mul(2).sub(0.4), 0, 1).oneMinus();
  const coverage = cover.mul(density);
  return max(coverage.x, coverage.y);
}
