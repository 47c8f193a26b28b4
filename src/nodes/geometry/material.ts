import { readReflectanceCsv } from '../../formats/attributes/spectrumCsv.ts';
import { assignMaterial } from '../../scene/compose/assignMaterial.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { measuredMaterial } from '../../scene/materials/measuredMaterial.ts';
import { InputError, type Material } from '../../scene/types.ts';
import { MATERIAL_PRESETS } from '../../spectrum/reflectance/materialPresets.ts';
import type { MeasuredReflectance } from '../../spectrum/reflectance/measuredReflectance.ts';
import { assertPathExists, nodeRefusal, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { Services } from '../services.ts';

const fractionParam = (title: string, value: number) =>
  ({ kind: 'number', title, default: value, min: 0, max: 1, step: 0.01 }) as const;
const CUSTOM_PRESET = { param: 'preset', is: 'own' } as const;

/** A surface material. */
export const materialNode = defineNode({
  id: 'material',
  title: 'node.material',
  help: 'node.material.help',
  category: 'geometry',
  params: {
    which: whichParam,
    preset: {
      kind: 'choice',
      title: 'param.preset',
      help: 'param.preset.help',
      default: 'own',
      options: [
        { value: 'own', title: 'preset.own' },
        ...[...MATERIAL_PRESETS.keys()].map((name) => ({ value: name, title: `preset.${name}` })),
      ],
    },
    reflectance: {
      kind: 'text',
      title: 'param.reflectance',
      help: 'param.reflectance.help',
      default: '',
      file: true,
      onlyWhen: CUSTOM_PRESET,
    },
    color: { kind: 'color', title: 'param.color', default: [0.5, 0.5, 0.5], onlyWhen: CUSTOM_PRESET },
    roughness: { ...fractionParam('param.roughness', 0.6), onlyWhen: CUSTOM_PRESET },
    metallic: { ...fractionParam('param.metallic', 0), onlyWhen: CUSTOM_PRESET },
    opacity: fractionParam('param.opacity', 1),
    glow: {
      kind: 'number',
      title: 'param.glow',
      help: 'param.glow.help',
      default: 0,
      min: 0,
      max: 1e6,
      step: 0.1,
      slider: false,
    },
    temperature: {
      kind: 'number',
      title: 'param.temperature',
      help: 'param.temperature.help',
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
  readonly glow: number;
  readonly temperature: number;
}

function materialOf(
  name: string,
  { preset, color, roughness, metallic, opacity, glow, temperature }: MaterialParams,
): Material {
  const substance = MATERIAL_PRESETS.get(preset);
  const shine = glow > 0 ? { emissive: [glow, glow, glow] as const, emissionTemperature: temperature } : {};
  if (!substance) return makeMaterial({ name, baseColor: color, roughness, metallic, opacity, ...shine });
  const { rgb, uv, ir } = substance.filter;
  const surface = { baseColor: rgb, uv, ir, roughness: substance.roughness, metallic: substance.metallic ? 1 : 0 };
  return makeMaterial({ name, ...surface, opacity, ...shine });
}
