import { abs, atan, clamp, dot, If, length, max, mix, radians, round, select, vec2, vec3, vec4 } from 'three/tsl';
import { LENS_GRID } from '../../scene/frameGraph/effects.ts';
import type { Float, Vec2, Vec3 } from '../../shaders/types.ts';
import { LENS_NUMBERS } from '../lenses/lensUniforms.ts';
import { isInPicture, panoramicDirection } from '../lenses/pixelDirection.ts';
import { singleStep } from './effect.ts';
import type { EffectContext } from './effectContext.ts';

/** Half the step of differences, which is within one pixel [px]. */
const STEP = 0.25;

/** `lensGrid` of reference/post/effects/lensGrid.ts. */
export const lensGrid = singleStep((frame) => {
  const [spacing, safe, opacity, width] = frame.args;
  const every = radians(spacing).toVar();
  const here = frame.image.at(frame.pixel).toVar();
  const { angles, gradients } = anglesOf(frame);
  const index = round(angles.div(every)).toVar();
  const [least, full] = LENS_GRID.gap;
  const shown = clamp(
    every
      .div(gradients)
      .sub(least)
      .div(full - least),
    0,
    1,
  );
  const isMain = clamp(abs(index), 0, 1).oneMinus();
  const off = abs(angles.sub(index.mul(every))).div(gradients);
  const lines = shown.mul(bandAt(off, isMain.add(1).mul(width))).toVar();
  const border = bandAt(vec2(abs(beyondPart(frame, safe))), vec2(width)).x;
  const lined = mix(here.rgb, vec3(...LENS_GRID.line), max(lines.x, lines.y).mul(opacity));
  const bordered = mix(lined, vec3(...LENS_GRID.border), select(safe.greaterThan(0), border.mul(opacity), 0));
  const isShown = isInPicture(frame.placeOf(frame.pixel), frame.uniforms.lens);
  return vec4(select(isShown, bordered, here.rgb), here.w);
});

/** The parts of a pixel that bands cover, whose middles are so far away [px]. */
const bandAt = (distance: Vec2, width: Vec2): Vec2 => clamp(width.mul(0.5).add(0.5).sub(distance), 0, 1);

/** Half the size of the part of the picture that the lens fills [px]. */
const halfFilled = (frame: EffectContext): Vec2 => frame.image.size.div(frame.uniforms.lens.scale).div(2);

/** A pixel's place in that part, from its middle [px], up. */
const placeIn = (frame: EffectContext): Vec2 => frame.placeOf(frame.pixel).mul(frame.image.size).div(2);

/** `GBufferReader.beyondPart` */
function beyondPart(frame: EffectContext, part: Float): Float {
  const reach = halfFilled(frame).mul(part).toVar();
  const place = placeIn(frame).toVar();
  const off = abs(place).sub(reach);
  const isFisheye = frame.uniforms.lens.kind.equal(LENS_NUMBERS.fisheye);
  return select(isFisheye, length(place).sub(reach.x), max(off.x, off.y));
}

/** Height above the horizon and bearing from the direction ahead [rad], and how much they change over a pixel; without sines, which GPUs have roughly. */
function anglesOf(frame: EffectContext): { angles: Vec2; gradients: Vec2 } {
  const { kind, aperture } = frame.uniforms.lens;
  const half = halfFilled(frame).toVar();
  const place = placeIn(frame).toVar();
  const [angles, gradients] = [vec2(0).toVar(), vec2(0).toVar()];
  If(kind.equal(LENS_NUMBERS.equirectangular), () => {
    const perPixel = vec2(Math.PI / 2, Math.PI).div(half.yx);
    angles.assign(place.yx.mul(perPixel));
    gradients.assign(perPixel);
  })
    .ElseIf(kind.equal(LENS_NUMBERS.fisheye), () => {
      const r = max(length(place), 1e-6).toVar();
      const perPixel = aperture.div(half.x.mul(2));
      angles.assign(
        vec2(
          r
            .mul(perPixel)
            .negate()
            .add(Math.PI / 2),
          atan(place.x, place.y.negate()),
        ),
      );
      gradients.assign(vec2(perPixel, r.reciprocal()));
    })
    .Else(() => {
      const { x, y, z } = planarDirection(frame, vec2(0)).toVar();
      const level = max(length(vec2(x, z)), 1e-12).toVar();
      const squared = level.mul(level).add(y.mul(y));
      angles.assign(vec2(atan(y, level), atan(x, z.negate())));
      // Linear in the place: differences are derivatives.
      const along = (step: Vec2): Vec2 => {
        const d = planarDirection(frame, step)
          .sub(planarDirection(frame, step.negate()))
          .div(2 * STEP)
          .toVar();
        const height = level
          .mul(d.y)
          .sub(y.mul(dot(vec2(x, z), d.xz)).div(level))
          .div(squared);
        return vec2(height, x.mul(d.z).sub(z.mul(d.x)).div(level.mul(level))).toVar();
      };
      const [across, down] = [along(vec2(STEP, 0)), along(vec2(0, STEP))];
      gradients.assign(vec2(length(vec2(across.x, down.x)), length(vec2(across.y, down.y))));
    });
  return { angles, gradients: max(gradients, 1e-12) };
}

/** A direction on the camera's axes, linear in the place beside this pixel's centre; of a perspective lens or a face of a cube. */
function planarDirection(frame: EffectContext, step: Vec2): Vec3 {
  const pixel = frame.pixel.add(step);
  const { lens } = frame.uniforms;
  const isPlane = lens.kind.equal(LENS_NUMBERS.perspective);
  return select(isPlane, vec3(frame.tangents(pixel), -1), panoramicDirection(frame.placeOf(pixel), lens));
}
