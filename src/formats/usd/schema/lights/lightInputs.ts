import { radians } from '../../../../math/angle.ts';
import { scale, type Vec3 } from '../../../../math/vec3.ts';
import { type Message, msg } from '../../../../messages/message.ts';
import type { DistantLight, LightShaping } from '../../../../scene/types.ts';
import { blackbodyColor } from '../../../../spectrum/color/blackbodyColor.ts';
import {
  parseSpectrum,
  SPECTRUM_ATTRIBUTE,
  thermalSpectrum,
  unknownSpectrumMessage,
} from '../../../attributes/spectrumAttribute.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numberAt, numbersAt, textAt, textOf, valueAt, vec3At } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { isTrue, type StageContext } from '../context.ts';
import { spectrumOfFile } from '../spectrumFiles.ts';

/** An input of a light: `inputs:name`, or `name` in files before USD 21. */
export const lightNumber = (context: StageContext, prim: PrimSpec, name: string): number | undefined =>
  numberAt(prim, `inputs:${name}`, context.startCode) ?? numberAt(prim, name, context.startCode);

export const lightFlag = (context: StageContext, prim: PrimSpec, name: string): boolean =>
  isTrue(context, prim, `inputs:${name}`) || isTrue(context, prim, name);

/** color · (colour of its temperature) · intensity · 2^exposure · diffuse; `intensity` is the fallback. */
export function emissionOf(context: StageContext, prim: PrimSpec, intensity = 1): Vec3 {
  const { startCode } = context;
  const color = vec3At(prim, 'inputs:color', startCode) ?? vec3At(prim, 'color', startCode) ?? [1, 1, 1];
  const diffuse = lightNumber(context, prim, 'diffuse') ?? 1;
  if ((lightNumber(context, prim, 'specular') ?? 1) !== diffuse) {
    const message = msg`its multiplier for diffuse light, ${diffuse}, is taken for specular light too`;
    report(context, 'info', 'usd.light-input', prim.path, message);
  }
  return emissionOfColor(context, prim, color, intensity);
}

/** The light's brightness with another colour. */
export function emissionOfColor(context: StageContext, prim: PrimSpec, color: Vec3, intensity = 1): Vec3 {
  const temperature = temperatureOf(context, prim);
  const warm = temperature === undefined ? [1, 1, 1] : blackbodyColor(temperature);
  const diffuse = lightNumber(context, prim, 'diffuse') ?? 1;
  const gain =
    (lightNumber(context, prim, 'intensity') ?? intensity) * 2 ** (lightNumber(context, prim, 'exposure') ?? 0);
  return scale([color[0] * warm[0], color[1] * warm[1], color[2] * warm[2]], gain * diffuse);
}

/** Colour temperature [K]; undefined unless enabled. */
const temperatureOf = (context: StageContext, prim: PrimSpec): number | undefined =>
  lightFlag(context, prim, 'enableColorTemperature')
    ? (lightNumber(context, prim, 'colorTemperature') ?? 6500)
    : undefined;

/** The light's spectrum by `slowlight:spectrum` (a name or a file) or its colour temperature; undefined if neither is authored. */
export async function spectrumOf(context: StageContext, prim: PrimSpec): Promise<Pick<DistantLight, 'spectrum'>> {
  const value = valueAt(attributeOf(prim, SPECTRUM_ATTRIBUTE), undefined);
  if (value?.type === 'asset') return spectrumOfFile(context, prim, value);
  const written = textOf(value);
  const named = written === undefined ? undefined : parseSpectrum(written);
  if (written !== undefined && !named)
    report(context, 'warning', 'usd.slowlight', prim.path, unknownSpectrumMessage(written));
  const temperature = temperatureOf(context, prim);
  const spectrum = named ?? (temperature === undefined ? undefined : thermalSpectrum(temperature));
  return spectrum ? { spectrum } : {};
}

/**
 * UsdLuxShapingAPI: no light beyond the cone's angle [degrees, from the axis], with a smooth edge over the fraction `softness` of it; focus is
 * an exponent of the cosine. Undefined if it has no effect: a face emits into a hemisphere anyway.
 */
export function shapingOf(context: StageContext, prim: PrimSpec, face: boolean): LightShaping | undefined {
  const shaping = (name: string): number | undefined => lightNumber(context, prim, `shaping:${name}`);
  const [angle, softness, focus] = [shaping('cone:angle'), shaping('cone:softness'), shaping('focus')];
  reportUnsupportedShaping(context, prim);
  if (angle === undefined && softness === undefined && focus === undefined) return undefined;
  const outer = radians(Math.min(Math.max(angle ?? 90, 0), 180));
  const inner = outer * (1 - Math.min(Math.max(softness ?? 0, 0), 1));
  const wide = outer >= Math.PI / (face ? 2 : 1);
  if (wide && inner === outer && !focus) return undefined;
  // A cone of 180° includes all directions: its edge has no effect.
  const limits = wide && inner === outer ? { inner: 4, outer: 5 } : { inner, outer };
  return { ...limits, focus: Math.max(focus ?? 0, 0) };
}

function reportUnsupportedShaping(context: StageContext, prim: PrimSpec): void {
  const tint = numbersAt(prim, 'inputs:shaping:focusTint', context.startCode) ?? [];
  const profile = ['inputs:shaping:ies:file', 'shaping:ies:file'].some((name) => textAt(prim, name, context.startCode));
  const say = (message: Message): void => report(context, 'info', 'usd.light-input', prim.path, message);
  if (profile) say(msg`the IES profile of the light is not applied`);
  if (Array.from(tint).some((x) => x !== 0)) say(msg`the focus tint of the light is not applied`);
  if (attributeOf(prim, 'inputs:shadow:enable') && !isShadowing(context, prim))
    say(msg`the want of shadows of the light is not applied`);
}

const isShadowing = (context: StageContext, prim: PrimSpec): boolean => isTrue(context, prim, 'inputs:shadow:enable');
