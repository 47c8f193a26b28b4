import { readReflectanceCsv } from '../../formats/attributes/spectrumCsv.ts';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { assignMaterial } from '../../scene/compose/assignMaterial.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { measuredMaterial } from '../../scene/materials/measuredMaterial.ts';
import { InputError, type Material } from '../../scene/types.ts';
import { MATERIAL_PRESETS } from '../../spectrum/reflectance/materialPresets.ts';
import type { MeasuredReflectance } from '../../spectrum/reflectance/measuredReflectance.ts';
import { assertPathExists, nodeRefusal, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { Services } from '../services.ts';

const fractionParam = (title: LocalizedText, value: number) =>
  ({ kind: 'number', title, default: value, min: 0, max: 1, step: 0.01 }) as const;
const PRESET_TITLES: Readonly<Record<string, Message>> = {
  leaf: msg`Leaf`,
  skin: msg`Skin`,
  asphalt: msg`Asphalt`,
  snow: msg`Snow`,
  gold: msg`Gold`,
  copper: msg`Copper`,
};
const DEFAULT_IOR = 1.5;
const CUSTOM_PRESET = { param: 'preset', is: 'own' } as const;

/** A surface material. */
export const materialNode = defineNode({
  id: 'material',
  title: msg`Material`,
  help: msg`The material of a surface, including ultraviolet and infrared.`,
  category: 'geometry',
  params: {
    which: whichParam,
    preset: {
      kind: 'choice',
      title: msg`Surface`,
      help: msg`A surface modelled on measurements, including ultraviolet and infrared, or a custom one.`,
      default: 'own',
      options: [
        { value: 'own', title: msg`Custom` },
        ...[...MATERIAL_PRESETS.keys()].map((name) => ({ value: name, title: PRESET_TITLES[name] ?? name })),
      ],
    },
    reflectance: {
      kind: 'text',
      title: msg`Reflectance`,
      help: msg`A CSV table: each line has a wavelength in nm and the reflected fraction, 0 to 1. The colour is then that of the table.`,
      default: '',
      file: true,
      onlyWhen: CUSTOM_PRESET,
    },
    color: { kind: 'color', title: msg`Colour`, default: [0.5, 0.5, 0.5], onlyWhen: CUSTOM_PRESET },
    roughness: { ...fractionParam(msg`Roughness`, 0.6), onlyWhen: CUSTOM_PRESET },
    metallic: { ...fractionParam(msg`Metallic`, 0), onlyWhen: CUSTOM_PRESET },
    opacity: fractionParam(msg`Opacity`, 1),
    ior: {
      kind: 'number',
      title: msg`Index of refraction`,
      help: msg`Determines how much is reflected, and how glass refracts: 1.33 is water, 1.5 glass, 2.42 diamond.`,
      default: DEFAULT_IOR,
      min: 1,
      max: 3,
      step: 0.01,
    },
    clearcoat: { ...fractionParam(msg`Clearcoat`, 0), help: msg`A clear varnish over everything else.` },
    clearcoatRoughness: {
      ...fractionParam(msg`Roughness of the clearcoat`, 0.1),
      onlyWhen: { param: 'clearcoat', isNot: 0 },
    },
    glow: {
      kind: 'number',
      title: msg`Emission`,
      help: msg`Emitted light; 1 is as bright as a white surface in full daylight.`,
      default: 0,
      min: 0,
      max: 1e6,
      step: 0.1,
      slider: false,
    },
    temperature: {
      kind: 'number',
      title: msg`Temperature`,
      help: msg`Temperature of the blackbody emission.`,
      unit: 'K',
      default: 6504,
      min: 500,
      max: 100_000,
      step: 1,
      scale: 'log',
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  async evaluate({ geometry }, { which, reflectance, ...how }, { node, services }) {
    assertPathExists(geometry.scene, which, node);
    const table = how.preset === 'own' && reflectance ? await readTable(reflectance, services) : undefined;
    const material = { ...materialOf(node, how), ...(table && measuredMaterial(table)) };
    return { geometry: { ...geometry, scene: assignMaterial(geometry.scene, which, material) } };
  },
});

async function readTable(source: string, services: Services): Promise<MeasuredReflectance> {
  try {
    return readReflectanceCsv(await services.readFile(source), source);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    const { code, place, message } = error.diagnostic;
    throw nodeRefusal(code, place, message);
  }
}

interface MaterialParams {
  readonly preset: string;
  readonly color: Material['baseColor'];
  readonly roughness: number;
  readonly metallic: number;
  readonly opacity: number;
  readonly ior: number;
  readonly clearcoat: number;
  readonly clearcoatRoughness: number;
  readonly glow: number;
  readonly temperature: number;
}

function materialOf(
  name: string,
  {
    preset,
    color,
    roughness,
    metallic,
    opacity,
    ior,
    clearcoat,
    clearcoatRoughness,
    glow,
    temperature,
  }: MaterialParams,
): Material {
  const substance = MATERIAL_PRESETS.get(preset);
  const layers = {
    ...(ior !== DEFAULT_IOR && { ior }),
    ...(clearcoat > 0 && { clearcoat: { factor: clearcoat, roughness: clearcoatRoughness } }),
  };
  const shine = glow > 0 ? { emissive: [glow, glow, glow] as const, emissionTemperature: temperature } : {};
  if (!substance) return makeMaterial({ name, baseColor: color, roughness, metallic, opacity, ...layers, ...shine });
  const { rgb, uv, ir } = substance.filter;
  const surface = { baseColor: rgb, uv, ir, roughness: substance.roughness, metallic: substance.metallic ? 1 : 0 };
  return makeMaterial({ name, ...surface, opacity, ...layers, ...shine });
}
