import { scale, type Vec3 } from '../../math/vec3.ts';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { assignMaterial } from '../../scene/compose/assignMaterial.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { measuredMaterial } from '../../scene/materials/measuredMaterial.ts';
import { InputError, type Material } from '../../scene/types.ts';
import { NANOMETRE } from '../../spectrum/observer/standardObserver.ts';
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
const GLASS = { param: 'transmission', isNot: 0 } as const;
const GROOVES = { param: 'anisotropy', isNot: 0 } as const;
const SHEEN = { param: 'sheen', isNot: 0 } as const;
const FILM = { param: 'iridescence', isNot: 0 } as const;
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
    transmission: {
      ...fractionParam(msg`Transmission`, 0),
      help: msg`Clear glass: what is not reflected passes, tinted by the colour.`,
    },
    thickness: {
      kind: 'number',
      title: msg`Thickness`,
      help: msg`0 is a thin sheet; a body refracts and absorbs. The fast renderer refracts by this thickness, the reference renderer by the shape.`,
      unit: 'm',
      default: 0,
      min: 0,
      max: 1e6,
      step: 0.01,
      slider: false,
      onlyWhen: GLASS,
    },
    attenuationColor: {
      kind: 'color',
      title: msg`Colour inside`,
      help: msg`What white light becomes after the absorption length.`,
      default: [1, 1, 1],
      onlyWhen: GLASS,
    },
    attenuationDistance: {
      kind: 'number',
      title: msg`Absorption length`,
      unit: 'm',
      default: 1,
      min: 1e-6,
      max: 1e6,
      step: 0.01,
      slider: false,
      onlyWhen: GLASS,
    },
    dispersion: {
      kind: 'number',
      title: msg`Dispersion`,
      help: msg`20 divided by the Abbe number: crown glass has 0.3, diamond 0.36, flint glass 0.55.`,
      default: 0,
      min: 0,
      max: 5,
      step: 0.01,
      onlyWhen: GLASS,
    },
    iridescence: {
      ...fractionParam(msg`Iridescence`, 0),
      help: msg`A thin film whose two sides' reflections interfere, as of soap and oil.`,
    },
    filmThickness: {
      kind: 'number',
      title: msg`Thickness of the film`,
      unit: 'nm',
      default: 400,
      min: 0,
      max: 10_000,
      step: 10,
      onlyWhen: FILM,
    },
    filmIor: {
      kind: 'number',
      title: msg`Index of refraction of the film`,
      default: 1.33,
      min: 1,
      max: 3,
      step: 0.01,
      onlyWhen: FILM,
    },
    anisotropy: {
      ...fractionParam(msg`Anisotropy`, 0),
      help: msg`Fine parallel grooves, as of brushed metal, which widen reflections along them.`,
    },
    anisotropyRotation: {
      kind: 'number',
      title: msg`Direction of the anisotropy`,
      unit: '°',
      default: 0,
      min: 0,
      max: 360,
      step: 1,
      onlyWhen: GROOVES,
    },
    sheen: {
      ...fractionParam(msg`Sheen`, 0),
      help: msg`Upright fibres over the surface, as of velvet and dust, which reflect at grazing angles.`,
    },
    sheenColor: { kind: 'color', title: msg`Colour of the sheen`, default: [1, 1, 1], onlyWhen: SHEEN },
    sheenRoughness: { ...fractionParam(msg`Roughness of the sheen`, 0.5), onlyWhen: SHEEN },
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
  const { readReflectanceCsv } = await import('../../formats/attributes/spectrumCsv.ts');
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
  readonly transmission: number;
  readonly thickness: number;
  readonly attenuationColor: Vec3;
  readonly attenuationDistance: number;
  readonly dispersion: number;
  readonly iridescence: number;
  readonly filmThickness: number;
  readonly filmIor: number;
  readonly anisotropy: number;
  readonly anisotropyRotation: number;
  readonly sheen: number;
  readonly sheenColor: Vec3;
  readonly sheenRoughness: number;
  readonly clearcoat: number;
  readonly clearcoatRoughness: number;
  readonly glow: number;
  readonly temperature: number;
}

function materialOf(name: string, params: MaterialParams): Material {
  const { preset, color, roughness, metallic, opacity, glow, temperature } = params;
  const substance = MATERIAL_PRESETS.get(preset);
  const shine = glow > 0 ? { emissive: [glow, glow, glow] as const, emissionTemperature: temperature } : {};
  const common = { name, opacity, ...layersOf(params), ...shine };
  if (!substance) return makeMaterial({ ...common, baseColor: color, roughness, metallic });
  const { rgb, uv, ir } = substance.filter;
  const surface = { baseColor: rgb, uv, ir, roughness: substance.roughness, metallic: substance.metallic ? 1 : 0 };
  return makeMaterial({ ...common, ...surface });
}

function layersOf(params: MaterialParams): Partial<Material> {
  const { ior, transmission, thickness, dispersion, clearcoat, clearcoatRoughness } = params;
  const { attenuationColor, attenuationDistance } = params;
  const { iridescence, filmThickness, filmIor, anisotropy, anisotropyRotation, sheen, sheenColor, sheenRoughness } =
    params;
  const isClear = transmission > 0;
  return {
    ...(ior !== DEFAULT_IOR && { ior }),
    ...(isClear && { transmission: { factor: transmission } }),
    ...(isClear && thickness > 0 && { volume: { thickness, attenuationColor, attenuationDistance } }),
    ...(isClear && dispersion > 0 && { dispersion }),
    ...(iridescence > 0 && {
      iridescence: { factor: iridescence, ior: filmIor, thickness: [0, filmThickness * NANOMETRE] as const },
    }),
    ...(anisotropy > 0 && {
      anisotropy: { strength: anisotropy, rotation: (anisotropyRotation * Math.PI) / 180 },
    }),
    ...(sheen > 0 && { sheen: { color: scale(sheenColor, sheen), roughness: sheenRoughness } }),
    ...(clearcoat > 0 && { clearcoat: { factor: clearcoat, roughness: clearcoatRoughness } }),
  };
}
