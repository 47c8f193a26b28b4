import {
  clamp,
  dot,
  ivec2,
  log2,
  max,
  pow,
  screenSize,
  screenUV,
  select,
  sqrt,
  texture,
  textureLoad,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Texture } from 'three/webgpu';
import { ontoLightCone } from '../../shaders/emission/ontoLightCone.ts';
import type { Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { ColorPipeline } from '../color/radiance.ts';
import type { Surface } from '../gbuffer/surface.ts';
import { cameraPosition, type SpacetimeProjection } from '../geometry/vertexStage.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { GlassView } from './layeredShading.ts';

/** Glass at a fragment. */
export interface Glass {
  /** [m]; 0 of a thin sheet. */
  readonly thickness: Float;
  readonly ior: Float;
  readonly attenuation: Vec4;
  /** 20 over the Abbe number; absent where no material is dispersive. */
  readonly dispersion?: Float;
}

/** Wavelengths of the primaries of sRGB, and of the line d [µm]. */
const [PRIMARIES, LINE_D] = [[0.611, 0.549, 0.464], 0.5876] as const;
/** n_F − n_C of B = 1 µm² in n = A + B/λ². */
const CAUCHY = 0.4861 ** -2 - 0.6563 ** -2;

/**
 * Light from behind glass: the picture where the refracted ray leaves the body, at its thickness below the surface (after the transmission pass of three.js).
 * The ray is refracted in the body's rest frame, where light takes n times as long; the event where it enters is found on the past light cone. What absorbs
 * acts on the light by its colour as it is seen with D.
 */
export function lightBehind(
  surface: Surface,
  { thickness, ior, attenuation, dispersion }: Glass,
  { rest, N, V }: GlassView,
  background: Texture,
  objects: Texture,
  place: SpacetimeProjection['place'],
  pipeline: ColorPipeline,
  uniforms: FrameUniforms,
): Vec3 {
  const blur = surface.roughness.mul(clamp(ior.mul(2).sub(2), 0, 1));
  const level = log2(max(screenSize.x, 1)).mul(blur).toVar();
  const from = ndcOf(surface.dx, place, uniforms).toVar();
  const seenThrough = (n: Float): Vec3 => {
    const cos = dot(N, V).toVar();
    const eta = n.reciprocal().toVar();
    const down = eta.mul(cos).sub(sqrt(max(eta.mul(eta).mul(cos.mul(cos).oneMinus()).oneMinus(), 0)));
    const inward = N.mul(down).sub(V.mul(eta)).mul(thickness);
    const way = rest.boostOut(vec4(inward, n.mul(thickness).negate()));
    const entered = vec4(surface.dx, surface.time).add(way).toVar();
    const event = select(uniforms.onLightCone.greaterThan(0.5), ontoLightCone(entered, surface.velocity), entered);
    const shift = ndcOf(event.xyz, place, uniforms).sub(from).toVar();
    const there = screenUV.add(vec2(shift.x, shift.y.negate()).mul(0.5)).toVar();
    // What stands before the glass is not behind it.
    const object = textureLoad(objects, ivec2(clamp(there, 0, 0.9999).mul(screenSize))).toVar();
    const isBefore = object.x.greaterThan(0.5).and(object.y.lessThan(surface.distance));
    const uv = select(isBefore, screenUV, clamp(there, 0, 1));
    return texture(background, uv).level(level).rgb;
  };
  const light = dispersion ? vec3(...channels(surface, ior, dispersion, seenThrough)) : seenThrough(ior);
  const passed = surface.color.rgb.mul(pow(max(attenuation.rgb, 1e-6), vec3(attenuation.w.mul(thickness))));
  return light.mul(shiftedFilter(passed, surface.D, pipeline, uniforms));
}

/** Each channel at the refractive index of its wavelength in the glass's rest frame. */
function channels({ D }: Surface, ior: Float, dispersion: Float, seen: (n: Float) => Vec3): [Float, Float, Float] {
  const B = ior
    .sub(1)
    .mul(dispersion)
    .div(20 * CAUCHY)
    .toVar();
  const [r, g, b] = PRIMARIES.map((wavelength, k) => {
    const there = D.mul(wavelength).toVar();
    const n = max(
      ior.add(
        B.mul(
          there
            .mul(there)
            .reciprocal()
            .sub(LINE_D ** -2),
        ),
      ),
      1,
    ).toVar();
    return seen(n).toVar()[(['x', 'y', 'z'] as const)[k]];
  });
  return [r, g, b];
}

/** What a filter does to each channel of light that is seen with D: the share of shifted daylight. */
function shiftedFilter(filter: Vec3, D: Float, pipeline: ColorPipeline, uniforms: FrameUniforms): Vec3 {
  const [tinted, white] = [filter, vec3(1)].map((color) => {
    const accumulator = pipeline(D, uniforms);
    accumulator.addEmitted(color);
    return accumulator.total().toVar();
  });
  return clamp(tinted.div(max(white, 1e-12)), 0, 1);
}

/** Where an event is seen, in half-pictures from the middle, right and up. */
function ndcOf(dx: Vec3, place: SpacetimeProjection['place'], uniforms: FrameUniforms): Vec2 {
  const { orientation, halfTangents, frustumCenter } = uniforms;
  const p = orientation
    .transpose()
    .mul(cameraPosition(dx, place, uniforms))
    .toVar();
  return p.xy.div(max(p.z.negate(), 1e-6)).sub(frustumCenter).div(halfTangents);
}
