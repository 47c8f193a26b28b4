import { abs, clamp, exp2, floor, log2, max, min, round, select, sqrt, step, vec3, vec4 } from 'three/tsl';
import type { Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import { relativeLuminance } from '../color/luminance.ts';
import { limitLight } from '../gpu/lightRange.ts';
import { decodeOctahedral, encodeOctahedral } from '../gpu/octahedral.ts';
import { CODE_OFFSET, GBUFFER_NORMAL_STEPS, NORMAL_LOW_STEPS, REFLECTANCE_STEPS } from '../gpu/packNormal.ts';

/*
 * What the G-buffer stores of a surface, in halves; all of the 64 bytes that a sample may have are used.
 *   base      base colour, roughness and occlusion
 *   emissive  emission, metalness and F₀
 *   normal    the normal (to 1.3e-4 rad), reflectance below 360 nm and beyond 830 nm
 */

/** What a surface emits: linear sRGB of daylight's spectrum, or a blackbody's light. */
export interface Emission {
  /** 0 if it is thermal. */
  readonly rgb: Vec3;
  /** 0 if it is not thermal. */
  readonly luminance: Float;
  /** log₂ of the temperature over that of daylight. */
  readonly log2Temperature: Float;
}

/** Emission of this colour, or of a blackbody of its luminance if `temperature` [K] is not 0. */
export function emissionOf(rgb: Vec3, temperature: Float): Emission {
  const thermal = temperature.greaterThan(0);
  return {
    rgb: select(thermal, vec3(0), rgb),
    luminance: select(thermal, relativeLuminance(rgb), 0),
    log2Temperature: log2(max(temperature, 1).div(DAYLIGHT.temperature)),
  };
}

/** The emission that is kept; brighter light is dimmed to it and keeps its hue. */
const MAX_EMISSION = 1e18;
/** Slightly below the largest half, and the smallest normal one. */
const [MAX_HALF, MIN_HALF] = [65_000, 2 ** -14];
/** A colour beyond halves is divided by a power of 2¹⁶, whose number is in the signs of red (its lower bit) and green. */
const COLOR_STEP = 16;
/**
 * A thermal luminance is divided by a power of 2¹⁶, the lowest of which is 2⁻⁹⁶. The temperature, as log₂ T/6504 K in steps of 2⁻¹⁴ from −13 on, is an integer of 19
 * bits: shifted by D, the light of an ember varies as up to the 40th power of T.
 */
const MIN_LUMINANCE_STEP = -6;
const [TEMPERATURE_STEPS, MIN_LOG2_TEMPERATURE] = [2 ** 14, -13];
/** Values of the lower 7 and upper 12 bits. */
const [TEMPERATURE_LOW, TEMPERATURE_HIGH] = [128, 4096];

/** A negative blue marks thermal emission: luminance, upper bits of the temperature, −1 − lower bits − 128 · luminance step. */
export function packEmission({ rgb, luminance, log2Temperature }: Emission): Vec3 {
  const bright = min(luminance, MAX_EMISSION).toVar();
  const luminanceStep = max(
    floor(log2(max(bright.div(MAX_HALF), 1e-30)).div(COLOR_STEP)).add(1),
    MIN_LUMINANCE_STEP,
  ).toVar();
  const temperature = clamp(
    round(log2Temperature.sub(MIN_LOG2_TEMPERATURE).mul(TEMPERATURE_STEPS)),
    0,
    TEMPERATURE_LOW * TEMPERATURE_HIGH - 1,
  ).toVar();
  const high = floor(temperature.div(TEMPERATURE_LOW)).toVar();
  const low = temperature.sub(high.mul(TEMPERATURE_LOW));
  const thermal = vec3(
    bright.mul(exp2(luminanceStep.mul(-COLOR_STEP))),
    high.sub(TEMPERATURE_HIGH / 2),
    luminanceStep.sub(MIN_LUMINANCE_STEP).mul(TEMPERATURE_LOW).add(low).add(1).negate(),
  );
  return select(luminance.greaterThan(0), thermal, packColor(limitLight(max(rgb, 0), MAX_EMISSION).toVar()));
}

function packColor(rgb: Vec3): Vec3 {
  const peak = max(rgb.x, max(rgb.y, rgb.z)).toVar();
  const stepsAbove = [0, 1, 2].map((k) => step(MAX_HALF * 2 ** (COLOR_STEP * k), peak));
  const steps = stepsAbove.reduce((sum, above) => sum.add(above)).toVar();
  // Zero has no sign.
  const scaled = max(rgb.mul(exp2(steps.mul(-COLOR_STEP))), MIN_HALF).toVar();
  const signs = vec3(select(steps.equal(1).or(steps.equal(3)), -1, 1), select(steps.greaterThanEqual(2), -1, 1), 1);
  return select(steps.greaterThan(0.5), scaled.mul(signs), rgb);
}

export function unpackEmission(code: Vec3): Emission {
  const thermal = code.z.lessThan(0);
  const scale = select(code.x.lessThan(0), 2 ** COLOR_STEP, 1).mul(
    select(code.y.lessThan(0), 2 ** (2 * COLOR_STEP), 1),
  );
  const whole = code.z.negate().sub(1).toVar();
  const luminanceStep = floor(whole.div(TEMPERATURE_LOW)).toVar();
  const temperature = code.y
    .add(TEMPERATURE_HIGH / 2)
    .mul(TEMPERATURE_LOW)
    .add(whole.sub(luminanceStep.mul(TEMPERATURE_LOW)));
  return {
    rgb: select(thermal, vec3(0), abs(code).mul(scale)),
    luminance: select(thermal, code.x.mul(exp2(luminanceStep.add(MIN_LUMINANCE_STEP).mul(COLOR_STEP))), 0),
    log2Temperature: select(thermal, temperature.div(TEMPERATURE_STEPS).add(MIN_LOG2_TEMPERATURE), 0),
  };
}

/** Metalness, 0 … 1, and reflectance at normal incidence of the non-metallic part. */
export interface SpecularParameters {
  readonly metallic: Float;
  readonly F0: Float;
}

/** Steps of √F₀ = (n − 1)/(n + 1) for a refractive index n: 1.5 is the 16th. The last one, 59/80, is n = 6.6 (F₀ = 0.54). */
const F0_STEPS = 80;

/** Metalness to 1/1020, √F₀ to 1/160. */
export const packSpecular = ({ metallic, F0 }: SpecularParameters): Float =>
  packTwo(metallic, round(sqrt(max(F0, 0)).mul(F0_STEPS)));

export function unpackSpecular(code: Float): SpecularParameters {
  const { fine, step } = unpackTwo(code);
  const fraction = step.div(F0_STEPS);
  return { metallic: fine, F0: fraction.mul(fraction) };
}

/** The first to 1/1020, the second to 1/118; both 0 … 1. */
export const packRoughnessAndOcclusion = (fine: Float, coarse: Float): Float =>
  packTwo(fine, round(clamp(coarse, 0, 1).mul(MAX_STEPS)));

export function unpackRoughnessAndOcclusion(code: Float): { readonly roughness: Float; readonly occlusion: Float } {
  const { fine, step } = unpackTwo(code);
  return { roughness: fine, occlusion: step.div(MAX_STEPS) };
}

/**
 * Two numbers in the bits of one half, ±2^e (1 + m): one in 60 steps, given by the exponents −14 … 15 and the sign; the other one, 0 … 1, in the mantissa,
 * except its ends.
 */
const MAX_STEPS = 59;
const EXPONENTS = 30;
const MIN_EXPONENT = -14;
const MANTISSA = 1024;
const MARGIN = 2;

function packTwo(fine: Float, requestedStep: Float): Float {
  const step = min(requestedStep, MAX_STEPS).toVar();
  const negative = step.greaterThanEqual(EXPONENTS);
  const exponent = select(negative, step.sub(EXPONENTS), step).add(MIN_EXPONENT);
  const mantissa = clamp(fine, 0, 1)
    .mul(MANTISSA - 2 * MARGIN)
    .add(MARGIN)
    .div(MANTISSA);
  const code = exp2(exponent).mul(mantissa.add(1));
  return select(negative, code.negate(), code);
}

function unpackTwo(code: Float): { readonly fine: Float; readonly step: Float } {
  const size = abs(code).toVar();
  const exponent = floor(log2(size)).toVar();
  const mantissa = size.mul(exp2(exponent.negate())).sub(1);
  const within = mantissa
    .mul(MANTISSA)
    .sub(MARGIN)
    .div(MANTISSA - 2 * MARGIN);
  const step = exponent.sub(MIN_EXPONENT).add(select(code.lessThan(0), EXPONENTS, 0));
  return { fine: clamp(within, 0, 1), step };
}

/** `unpackTwo` of a code that was read back: the number in its mantissa. */
export function unpackFine(code: number): number {
  const size = Math.abs(code);
  const mantissa = size / 2 ** Math.floor(Math.log2(size)) - 1;
  return Math.min(Math.max((mantissa * MANTISSA - MARGIN) / (MANTISSA - 2 * MARGIN), 0), 1);
}

/**
 * The normal, and `invisible`: reflectance below 360 nm and beyond 830 nm. Four integers of 12 bits, which halves hold exactly: the upper bits of the
 * normal's two coordinates, and 9 bits of each reflectance with the lower 3 of a coordinate (also read by `unpackGBufferNormal` in packNormal.ts).
 */
export function packNormals(normal: Vec3, invisible: Vec2): Vec4 {
  const fine = round(encodeOctahedral(normal).mul(0.5).add(0.5).clamp(0, 1).mul(GBUFFER_NORMAL_STEPS)).toVar();
  const coarse = floor(fine.div(NORMAL_LOW_STEPS)).toVar();
  const reflectanceSteps = round(clamp(invisible, 0, 1).mul(REFLECTANCE_STEPS));
  return vec4(coarse, reflectanceSteps.sub(coarse).mul(NORMAL_LOW_STEPS).add(fine)).sub(CODE_OFFSET);
}

export function unpackNormals(code: Vec4): { readonly normal: Vec3; readonly invisible: Vec2 } {
  const whole = code.add(CODE_OFFSET).toVar();
  const reflectanceSteps = floor(whole.zw.div(NORMAL_LOW_STEPS)).toVar();
  const fine = whole.xy.sub(reflectanceSteps).mul(NORMAL_LOW_STEPS).add(whole.zw);
  return {
    normal: decodeOctahedral(
      fine
        .mul(2 / GBUFFER_NORMAL_STEPS)
        .sub(1)
        .toVar(),
    ),
    invisible: reflectanceSteps.div(REFLECTANCE_STEPS),
  };
}
