import { readReflectanceCsv } from '../../formats/spectrumCsv.ts';
import { dress } from '../../scene/compose/dress.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { measuredSurface } from '../../scene/measuredSurface.ts';
import { InputError, type Material } from '../../scene/types.ts';
import { MATERIAL_PRESETS } from '../../spectrum/materialPresets.ts';
import type { Reflectance } from '../../spectrum/measured.ts';
import { defineNode } from '../define.ts';
import type { Services } from '../services.ts';
import { checkPath, refusal, whichParam } from './shared.ts';

const share = (title: string, value: number) =>
  ({ kind: 'number', title, default: value, min: 0, max: 1, step: 0.01 }) as const;
const OWN = { param: 'preset', is: 'own' } as const;

/** What a surface is of. */
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
      onlyWhen: OWN,
    },
    color: { kind: 'color', title: 'param.color', default: [0.5, 0.5, 0.5], onlyWhen: OWN },
    roughness: { ...share('param.roughness', 0.6), onlyWhen: OWN },
    metallic: { ...share('param.metallic', 0), onlyWhen: OWN },
    opacity: share('param.opacity', 1),
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
    checkPath(geometry.scene, which, node);
    const table = how.preset === 'own' && reflectance ? await readTable(reflectance, services) : undefined;
    const material = { ...materialOf(node, how), ...(table && measuredSurface(table)) };
    return { geometry: { ...geometry, scene: dress(geometry.scene, which, material) } };
  },
});

async function readTable(source: string, services: Services): Promise<Reflectance> {
  try {
    return readReflectanceCsv(await services.readFile(source), source);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    const { code, place, message } = error.diagnostic;
    throw refusal(code, place, message);
  }
}

interface Looks {
  readonly preset: string;
  readonly color: Material['baseColor'];
  readonly roughness: number;
  readonly metallic: number;
  readonly opacity: number;
  readonly glow: number;
  readonly temperature: number;
}

function materialOf(name: string, { preset, color, roughness, metallic, opacity, glow, temperature }: Looks): Material {
  const known = MATERIAL_PRESETS.get(preset);
  const shine = glow > 0 ? { emissive: [glow, glow, glow] as const, emissionTemperature: temperature } : {};
  if (!known) return makeMaterial({ name, baseColor: color, roughness, metallic, opacity, ...shine });
  const { rgb, uv, ir } = known.bands;
  const surface = { baseColor: rgb, uv, ir, roughness: known.roughness, metallic: known.metallic ? 1 : 0 };
  return makeMaterial({ name, ...surface, opacity, ...shine });
}
