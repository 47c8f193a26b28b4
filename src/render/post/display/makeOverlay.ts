import {
  clamp,
  dot,
  Fn,
  float,
  fract,
  If,
  ivec2,
  length,
  max,
  mix,
  screenCoordinate,
  select,
  sign,
  smoothstep,
  step,
  textureLoad,
  textureSize,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Float, Vec3, Vec4 } from '../../../shaders/types.ts';
import { OVERLAY_COLORS } from '../../../spectrum/display/overlayColors.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import { unpackNormals } from '../../gbuffer/surfacePacking.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { texelHere } from '../../gpu/fullScreenPass.ts';
import type { PictureOverlay } from './overlay.ts';

interface OverlaySources {
  readonly picture: GBuffer;
  readonly uniforms: FrameUniforms;
  /** Whether what is before and after the observer's world time is drawn apart. */
  readonly pastFuture: boolean;
  /** Of the ghost; absent: there is none. */
  readonly ghost?: GBuffer;
  /** Whether only contours of what moves are drawn: from outside, what rests is in one place in all views. */
  readonly onlyMoving: boolean;
}

/** The overlay of a picture: its past and future parts, and the contours of its ghost. */
export function makeOverlay({ picture, uniforms, pastFuture, ghost, onlyMoving }: OverlaySources): PictureOverlay {
  const contours = () => (ghost ? [contoursOf(ghost, pastFuture, onlyMoving).toVar()] : []);
  return {
    key: `${ghost?.depth.id} ${pastFuture} ${onlyMoving}`,
    contours,
    layers: () => [...(pastFuture ? [partsOf(picture, uniforms).toVar()] : []), ...contours()],
  };
}

/** −1 in the past of the observer's world time, 1 in its future, 0 on it but for rounding. `event`: (Δx, cΔt) [m], world frame. */
const partOf = (event: Vec4): Float => sign(event.w).mul(step(length(event.xyz).mul(MIN_PART_SLOPE), event.w.abs()));
/** Least |cΔt|/|Δx| that is not rounding. */
const MIN_PART_SLOPE = 1e-5;

const partColor = (part: Float, now: Vec3): Vec3 =>
  select(
    part.lessThan(0),
    vec3(...OVERLAY_COLORS.past),
    select(part.greaterThan(0), vec3(...OVERLAY_COLORS.future), now),
  );

/** Distance of hatching lines, the share of it that they take [px], and coverage between and on them. */
const HATCH = { spacing: 14, share: 0.14, between: 0.15, on: 0.4 } as const;

/** Tints and hatches both parts, the past falling and the future rising to the right. Nothing of the past light cone: all of it is past. */
const partsOf = (buffer: GBuffer, { onLightCone }: FrameUniforms): Vec4 =>
  Fn(() => {
    const part = partOf(texelHere(buffer.texture('event')).toVar()).toVar();
    const hasSurface = step(0.5, texelHere(buffer.texture('object')).x);
    const { x, y } = screenCoordinate;
    const line = step(fract(x.add(y.mul(part)).div(HATCH.spacing)), HATCH.share);
    const cover = mix(float(HATCH.between), float(HATCH.on), line).mul(part.abs()).mul(hasSurface);
    return vec4(partColor(part, vec3(0)), cover.mul(onLightCone.oneMinus()));
  })();

/** Pixels at whose distance contours are bordered by a dark seam, which sets them off from bright pictures. */
const AROUND = [
  [2, 0],
  [-2, 0],
  [0, 2],
  [0, -2],
  [1, 1],
  [1, -1],
  [-1, 1],
  [-1, -1],
] as const;
const SEAM_COVER = 0.5;
/** 1 − cos of the angles between neighbouring normals at which creases begin, and are full. */
const CREASE = [0.12, 0.25] as const;
const CREASE_COVER = 0.7;
/** Second differences of 1/|Δx′|, as a share of it, at which steps within one object begin, and are full. */
const STEP = [0.05, 0.1] as const;
/** Least speed of what moves, of c. */
const MIN_SPEED = 1e-5;
/** Rows of a picture for each pixel of half the width of a contour. */
const ROWS_PER_PIXEL = 1080;

/** A neighbouring pixel: 1 if it shows the same object, and by how much this pixel's 1/|Δx′| is more [1/m]. */
interface Side {
  readonly same: Float;
  readonly change: Float;
}

const secondDifference = (a: Side, b: Side): Float => a.change.add(b.change).abs().mul(a.same).mul(b.same);

/**
 * Contours of a G-buffer: where the object changes, and at creases and steps within one. Two pixels wide, half of them on either side; the colour is that of
 * the part of time which the nearer side belongs to, if these are told apart.
 */
const contoursOf = (ghost: GBuffer, pastFuture: boolean, onlyMoving: boolean): Vec4 =>
  Fn(() => {
    const [objects, normals] = [ghost.texture('object'), ghost.texture('normal')];
    // The cast corrects the declared type of `textureSize`.
    const size = vec2(textureSize(textureLoad(objects)) as unknown as Node<'ivec2'>).toVar();
    const reach = max(size.y.div(ROWS_PER_PIXEL).round(), 1).toVar();
    const beside = (i: number, j: number) =>
      ivec2(clamp(screenCoordinate.add(vec2(i, j).mul(reach)), vec2(0), size.sub(1)));
    const here = texelHere(objects).toVar();
    const inverse = (surface: Vec4): Float => select(surface.x.greaterThan(0.5), surface.y.reciprocal(), 0);
    const nearness = inverse(here).toVar();
    const normal = unpackNormals(texelHere(normals)).normal.toVar();
    const event = texelHere(ghost.texture('event')).toVar();
    const nearest = nearness.toVar();
    const outline = float(0).toVar();
    const crease = float(0).toVar();
    const speedOf = (pixel: Node<'ivec2'>) => length(textureLoad(ghost.texture('motion'), pixel).xyz);
    const fastest = (onlyMoving ? speedOf(ivec2(screenCoordinate)) : float(1)).toVar();
    const side = (i: number, j: number): Side => {
      const pixel = beside(i, j).toVar();
      const surface = textureLoad(objects, pixel).toVar();
      const other = inverse(surface).toVar();
      const same = step(surface.x.sub(here.x).abs(), 0.5).toVar();
      outline.assign(max(outline, same.oneMinus()));
      const turn = dot(normal, unpackNormals(textureLoad(normals, pixel)).normal).oneMinus();
      crease.assign(max(crease, smoothstep(...CREASE, turn).mul(same)));
      if (onlyMoving) fastest.assign(max(fastest, speedOf(pixel)));
      if (pastFuture)
        If(other.greaterThan(nearest), () => {
          nearest.assign(other);
          event.assign(textureLoad(ghost.texture('event'), pixel));
        });
      return { same, change: nearness.sub(other) };
    };
    const bend = max(secondDifference(side(-1, 0), side(1, 0)), secondDifference(side(0, -1), side(0, 1)))
      .div(max(nearness, 1e-30))
      .toVar();
    const inner = max(crease, smoothstep(...STEP, bend))
      .mul(CREASE_COVER)
      .mul(step(0.5, here.x));
    const line = max(outline, inner).toVar();
    const seam = float(0).toVar();
    for (const [i, j] of AROUND) {
      seam.assign(max(seam, step(0.5, textureLoad(objects, beside(i, j)).x.sub(here.x).abs())));
      if (onlyMoving) fastest.assign(max(fastest, speedOf(beside(i, j))));
    }
    const now = vec3(...OVERLAY_COLORS.contour);
    const color = pastFuture ? partColor(partOf(event), now) : now;
    const dark = seam.mul(SEAM_COVER).mul(line.oneMinus());
    const cover = line.add(dark).mul(step(MIN_SPEED, fastest)).toVar();
    return vec4(color.mul(line).div(max(cover, 1e-6)), cover);
  })();
